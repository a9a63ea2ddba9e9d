#include "render/video/video.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "render/parts/load_part.h"
#include "render/video/video_files.h"
#include "render/video/webp_probe.h"

namespace mien::render {

namespace {

const VideoFiles& video_files() {
  static const auto* const files = static_cast<const VideoFiles*>(
      load_part("mien-video-files.so", "reads and writes videos", video_files_edition));
  return *files;
}

}  // namespace

VideoWriter::VideoWriter(const std::filesystem::path& path, const VideoFormat& format)
    : encoder_(video_files().writer(path, format)) {}
VideoWriter::~VideoWriter() = default;
VideoWriter::VideoWriter(VideoWriter&&) noexcept = default;
VideoWriter& VideoWriter::operator=(VideoWriter&&) noexcept = default;

void VideoWriter::write(const Image8& frame) { encoder_->write(frame); }
void VideoWriter::finish() { encoder_->finish(); }
const VideoReceipt& VideoWriter::receipt() const { return encoder_->receipt(); }

VideoSummary probe_timed(const std::filesystem::path& path,
                         const std::function<void(const TimedPicture&)>& on_picture, int row_step) {
  if (is_webp(path)) return probe_webp(path, on_picture);
  return video_files().probe(path, on_picture, row_step);
}

VideoSummary probe_in_parallel(const std::filesystem::path& path,
                               const std::function<void(const TimedPicture&)>& on_picture,
                               int row_step, int threads) {
  if (is_webp(path)) return probe_webp(path, on_picture);
  return video_files().probe_in_parallel(path, on_picture, row_step, threads);
}

VideoSummary probe(const std::filesystem::path& path,
                   const std::function<void(int, const Image8&)>& on_frame) {
  if (!on_frame) return probe_timed(path, {});
  return probe_timed(path,
                     [&](const TimedPicture& shown) { on_frame(shown.index, shown.picture); });
}

Image8 decode_first_picture(const std::filesystem::path& path) {
  return is_webp(path) ? decode_first_webp_picture(path) : video_files().decode_first_picture(path);
}

std::string video_libraries() {
  const auto version = [](const char* library, std::string (VideoFiles::*own)() const) {
    const std::string of_file = version_of_library(library);
    return of_file.empty() ? (video_files().*own)() : of_file;
  };
  return "libavcodec " + version(MIEN_LIBAVCODEC, &VideoFiles::libavcodec) + ", libavformat " +
         version(MIEN_LIBAVFORMAT, &VideoFiles::libavformat) + ", libswscale " +
         version(MIEN_LIBSWSCALE, &VideoFiles::libswscale);
}

FrameRate frame_rate(double per_second) {
  if (!(per_second > 0.0) || !std::isfinite(per_second)) {
    throw std::invalid_argument("frame_rate: not positive");
  }
  const double whole = std::round(per_second);
  if (whole >= 1.0 && std::abs(per_second - whole) < 1e-6 * whole) {
    return {static_cast<int>(whole), 1};
  }
  const double ntsc = std::round(per_second * 1.001);
  if (std::abs(per_second - ntsc / 1.001) < 1e-4 * per_second) {
    return {static_cast<int>(ntsc) * 1000, 1001};
  }
  FrameRate best{static_cast<int>(std::max(1.0, whole)), 1};
  for (int denominator = 1; denominator <= 1000; ++denominator) {
    const FrameRate rate{static_cast<int>(std::round(per_second * denominator)), denominator};
    if (rate.numerator > 0 && std::abs(rate.per_second() - per_second) <
                                  std::abs(best.per_second() - per_second) - 1e-12) {
      best = rate;
    }
  }
  return best;
}

}  // namespace mien::render
