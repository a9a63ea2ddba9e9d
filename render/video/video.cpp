#include "render/video/video.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <stdexcept>

#include "render/error.h"
#include "render/image_files/image_files.h"
#include "render/image_files/picture_limits.h"
#include "render/parts/load_part.h"
#include "render/video/video_files.h"

namespace mien::render {

namespace {

// Animated WebP, which FFmpeg writes but does not read.

std::uint32_t little_endian(const unsigned char* bytes, int count) {
  std::uint32_t value = 0;
  for (int i = 0; i < count; ++i) value |= std::uint32_t{bytes[i]} << (8 * i);
  return value;
}

/// The durations of the pictures, milliseconds, by walking over the file's chunks; 0 for a picture
/// that is not animated.
std::vector<int> durations_of(const std::filesystem::path& path) {
  const auto broken = [&] { return Error(path.string() + ": is cut short"); };
  std::ifstream file(path, std::ios::binary);
  unsigned char head[12];
  if (!file.read(reinterpret_cast<char*>(head), 12)) throw broken();
  const std::uint64_t end = std::uint64_t{little_endian(head + 4, 4)} + 8;
  if (std::filesystem::file_size(path) < end) throw broken();
  std::vector<int> durations;
  std::uint64_t at = 12;
  while (at + 8 <= end) {
    unsigned char chunk[24];
    file.seekg(static_cast<std::streamoff>(at));
    if (!file.read(reinterpret_cast<char*>(chunk), 8)) throw broken();
    const std::uint32_t size = little_endian(chunk + 4, 4);
    if (std::memcmp(chunk, "ANMF", 4) == 0) {
      if (!file.read(reinterpret_cast<char*>(chunk + 8), 16)) throw broken();
      durations.push_back(static_cast<int>(little_endian(chunk + 20, 3)));
    }
    at += 8 + std::uint64_t{size} + size % 2;
  }
  if (at != end) throw broken();
  if (durations.empty()) durations.push_back(0);
  return durations;
}

using Reader = std::unique_ptr<ImageFile>;

Reader opened(const std::filesystem::path& path) {
  std::string error;
  Reader reader = image_files().open(path.string(), error);
  if (!reader) throw Error(path.string() + ": opening: " + error);
  return reader;
}

Image8 picture_of(ImageFile& reader, int index, const std::filesystem::path& path) {
  const auto fail = [&] {
    return Error(path.string() + ": decoding frame " + std::to_string(index) + ": " +
                 reader.error());
  };
  if (!reader.select(index)) throw fail();
  const ImageLayout& layout = reader.layout();
  const std::size_t channels = layout.channels.size();
  if (channels < 3) throw fail();
  require_readable_size(path.string(), layout.width, layout.height, channels);
  std::vector<std::uint8_t> pixels(channels * static_cast<std::size_t>(layout.width) *
                                   static_cast<std::size_t>(layout.height));
  if (!reader.read(ChannelKind::byte, pixels.data())) throw fail();
  Image8 image(layout.width, layout.height);
  for (std::size_t i = 0; i < image.channels.size() / 3; ++i) {
    std::memcpy(image.channels.data() + 3 * i, pixels.data() + channels * i, 3);
  }
  return image;
}

/// Whether a file begins like a WebP.
bool is_webp(const std::filesystem::path& path) {
  char head[12] = {};
  std::ifstream(path, std::ios::binary).read(head, sizeof head);
  return std::memcmp(head, "RIFF", 4) == 0 && std::memcmp(head + 8, "WEBP", 4) == 0;
}

/// See probe_timed. Throws Error when the file is cut short or a picture does not decode.
VideoSummary probe_webp(const std::filesystem::path& path,
                        const std::function<void(const TimedPicture&)>& on_picture) {
  const std::vector<int> durations = durations_of(path);
  const Reader reader = opened(path);
  VideoSummary summary;
  summary.container = "webp";
  summary.codec = "webp";
  summary.width = reader->layout().width;
  summary.height = reader->layout().height;
  summary.tick_seconds = 0.001;
  summary.starts_with_key_frame = true;
  int milliseconds = 0;
  for (const int duration : durations) {
    const double seconds = 0.001 * milliseconds;
    const Image8 picture = picture_of(*reader, summary.frames, path);
    if (on_picture) on_picture({summary.frames, seconds, 0.001 * duration, picture});
    summary.times.push_back(seconds);
    milliseconds += duration;
    ++summary.frames;
  }
  summary.duration_seconds = 0.001 * milliseconds;
  if (milliseconds > 0) summary.rate = frame_rate(summary.frames / summary.duration_seconds);
  return summary;
}

/// See decode_first_picture: the bytes of the first picture are those of its chunk.
Image8 decode_first_webp_picture(const std::filesystem::path& path) {
  return picture_of(*opened(path), 0, path);
}

}  // namespace

const VideoFiles& video_files() {
  static const auto* const files = static_cast<const VideoFiles*>(
      load_part("mien-video-files.so", "reads and writes videos", video_files_edition));
  return *files;
}

VideoWriter::VideoWriter(const std::filesystem::path& path, const VideoFormat& format,
                         const Sound* sound)
    : encoder_(video_files().writer(path, format, sound)) {}
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
