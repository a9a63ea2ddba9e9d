#include "render/video/video.h"

#include "render/parts/loaded_part.h"
#include "render/video/video_files.h"
#include "render/video/webp_probe.h"

namespace mien::render {

namespace {

const VideoFiles& video_files() {
  static const auto* const files = static_cast<const VideoFiles*>(
      loaded_part("mien-video-files.so", "reads and writes videos", video_files_edition));
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
                         const std::function<void(const ShownPicture&)>& on_picture, int row_step) {
  if (is_webp(path)) return probe_webp(path, on_picture);
  return video_files().probe(path, on_picture, row_step);
}

VideoSummary probe_side_by_side(const std::filesystem::path& path,
                                const std::function<void(const ShownPicture&)>& on_picture,
                                int row_step, int threads) {
  if (is_webp(path)) return probe_webp(path, on_picture);
  return video_files().probe_side_by_side(path, on_picture, row_step, threads);
}

VideoSummary probe(const std::filesystem::path& path,
                   const std::function<void(int, const Image8&)>& on_frame) {
  if (!on_frame) return probe_timed(path, {});
  return probe_timed(path,
                     [&](const ShownPicture& shown) { on_frame(shown.index, shown.picture); });
}

Image8 first_picture_alone(const std::filesystem::path& path) {
  return is_webp(path) ? first_webp_picture(path) : video_files().first_picture_alone(path);
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

}  // namespace mien::render
