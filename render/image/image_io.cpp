#include "render/image/image_io.h"

#include <cstdint>
#include <memory>
#include <vector>

#include "render/error.h"
#include "render/image/png_file.h"
#include "render/image_files/image_files.h"
#include "render/image_files/picture_limits.h"

namespace mien::render {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& wrong) {
  throw Error(path.string() + ": " + wrong);
}

void write(const std::filesystem::path& path, const ImagePart& part) {
  std::string error;
  if (!image_files().write(path.string(), {part}, error)) fail(path, error);
}

template <class Channel>
constexpr int bits_of = 8 * static_cast<int>(sizeof(Channel));

template <class Channel>
void write_png_of(const std::filesystem::path& path, const Image<Channel>& image) {
  write_png_file(path, {.width = image.width,
                        .height = image.height,
                        .bits = bits_of<Channel>,
                        .values = image.channels.data()});
}

template <class Channel>
Image<Channel> read_png_of(const std::filesystem::path& path) {
  PngFile file(path);
  if (file.channels() != 3) fail(path, "does not have three channels");
  if (file.bits() != bits_of<Channel>) fail(path, "has a different number of bits per channel");
  require_readable_size(path.string(), file.width(), file.height(), 3);
  Image<Channel> image(file.width(), file.height());
  file.read(image.channels.data());
  return image;
}

std::unique_ptr<ImageFile> opened(const std::filesystem::path& path, const char* format) {
  std::string error;
  std::unique_ptr<ImageFile> file = image_files().open(path.string(), error);
  if (!file) fail(path, error);
  if (format != nullptr && file->layout().format != format)
    fail(path, std::string("is not ") + format + " but " + file->layout().format);
  return file;
}

}  // namespace

void write_png(const std::filesystem::path& path, const Image8& image) {
  write_png_of(path, image);
}

void write_png(const std::filesystem::path& path, const Image16& image) {
  write_png_of(path, image);
}

void write_png(const std::filesystem::path& path, const RenderTarget& target, const Tone& tone) {
  Framebuffer straight = target.color;
  for (std::size_t i = 0; i < target.alpha.size(); ++i) {
    const float scale = target.alpha[i] > 0.0f ? 1.0f / target.alpha[i] : 0.0f;
    for (std::size_t c = 0; c < 3; ++c) straight.channels[3 * i + c] *= scale;
  }
  const Image8 colours = to_srgb8(straight, tone);
  std::vector<std::uint8_t> channels;
  channels.reserve(4 * target.alpha.size());
  for (std::size_t i = 0; i < target.alpha.size(); ++i) {
    channels.insert(channels.end(), {colours.channels[3 * i], colours.channels[3 * i + 1],
                                     colours.channels[3 * i + 2],
                                     static_cast<std::uint8_t>(255.0f * target.alpha[i] + 0.5f)});
  }
  write(path, {.width = colours.width,
               .height = colours.height,
               .count = 4,
               .attributes = {{"oiio:ColorSpace", "sRGB"},
                              // Light is given as PNG keeps it.
                              {"oiio:UnassociatedAlpha", 1}},
               .values = channels.data()});
}

void write_exr(const std::filesystem::path& path, const Framebuffer& framebuffer, ExrDepth depth) {
  // Without a date, OpenImageIO writes the time at which the file is made.
  write(path,
        {.width = framebuffer.width,
         .height = framebuffer.height,
         .stored = depth == ExrDepth::Half ? ChannelKind::half : ChannelKind::single,
         .attributes = {{"oiio:ColorSpace", "Linear"}, {"compression", "zip"}, {"DateTime", ""}},
         .given = ChannelKind::single,
         .values = framebuffer.channels.data()});
}

Image8 read_png8(const std::filesystem::path& path) { return read_png_of<std::uint8_t>(path); }

Image16 read_png16(const std::filesystem::path& path) { return read_png_of<std::uint16_t>(path); }

Framebuffer read_exr(const std::filesystem::path& path) {
  const std::unique_ptr<ImageFile> file = opened(path, "openexr");
  const ImageLayout& layout = file->layout();
  if (layout.channels.size() != 3) fail(path, "does not have three channels");
  require_readable_size(path.string(), layout.width, layout.height, 3);
  Framebuffer framebuffer(layout.width, layout.height);
  if (!file->read(ChannelKind::single, framebuffer.channels.data())) fail(path, file->error());
  return framebuffer;
}

ImageSummary check_image(const std::filesystem::path& path) {
  const std::unique_ptr<ImageFile> file = opened(path, nullptr);
  const ImageLayout& layout = file->layout();
  require_readable_size(path.string(), layout.width, layout.height, layout.channels.size());
  std::vector<float> channels(static_cast<std::size_t>(layout.width) *
                              static_cast<std::size_t>(layout.height) * layout.channels.size());
  if (!file->read(ChannelKind::single, channels.data())) fail(path, file->error());
  return {.format = layout.format,
          .width = layout.width,
          .height = layout.height,
          .channels = static_cast<int>(layout.channels.size()),
          .bits = layout.bits,
          .color_space = layout.color_space};
}

std::string image_library() { return "OpenImageIO " + image_files_version(); }

}  // namespace mien::render
