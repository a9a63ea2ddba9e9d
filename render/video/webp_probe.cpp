#include "render/video/webp_probe.h"

#include <cstring>
#include <fstream>
#include <memory>
#include <vector>

#include "render/error.h"
#include "render/image_files/image_files.h"
#include "render/image_files/picture_limits.h"

namespace mien::render {

namespace {

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

}  // namespace

bool is_webp(const std::filesystem::path& path) {
  char head[12] = {};
  std::ifstream(path, std::ios::binary).read(head, sizeof head);
  return std::memcmp(head, "RIFF", 4) == 0 && std::memcmp(head + 8, "WEBP", 4) == 0;
}

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

Image8 decode_first_webp_picture(const std::filesystem::path& path) {
  return picture_of(*opened(path), 0, path);
}

}  // namespace mien::render
