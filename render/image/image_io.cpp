#include "render/image/image_io.h"

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "render/error.h"
#include "render/image_files/image_files.h"

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
void write_png_of(const std::filesystem::path& path, const Image<Channel>& image,
                  ChannelKind depth) {
  ImagePart part{.width = image.width,
                 .height = image.height,
                 .stored = depth,
                 .attributes = {{"oiio:ColorSpace", "sRGB"}},
                 .given = depth,
                 .values = image.channels.data()};
  // Rendered gradients gain little from more effort, and a frame is written many times as fast.
  if constexpr (sizeof(Channel) == 1) {
    // Few codes, each often repeated: unfiltered rows are smaller, and written three times as fast.
    constexpr int unfiltered = 8;  // PNG_FILTER_NONE
    part.attributes.emplace_back("png:compressionLevel", 2);
    part.attributes.emplace_back("png:filter", unfiltered);
  } else {
    part.attributes.emplace_back("png:compressionLevel", 3);
  }
  write(path, part);
}

std::unique_ptr<ImageFile> opened(const std::filesystem::path& path, const char* format) {
  std::string error;
  std::unique_ptr<ImageFile> file = image_files().open(path.string(), error);
  if (!file) fail(path, error);
  if (format != nullptr && file->layout().format != format)
    fail(path, std::string("is not ") + format + " but " + file->layout().format);
  return file;
}

template <class Channel>
Image<Channel> read(const std::filesystem::path& path, const char* format, ChannelKind wanted) {
  const std::unique_ptr<ImageFile> file = opened(path, format);
  const ImageLayout& layout = file->layout();
  if (layout.channels.size() != 3) fail(path, "does not have three channels");
  if (format == std::string("png") && layout.stored != wanted)
    fail(path, "has another number of bits a channel");
  Image<Channel> image(layout.width, layout.height);
  if (!file->read(wanted, image.channels.data())) fail(path, file->error());
  return image;
}

}  // namespace

void write_png(const std::filesystem::path& path, const Image8& image) {
  write_png_of(path, image, ChannelKind::byte);
}

void write_png(const std::filesystem::path& path, const Image16& image) {
  write_png_of(path, image, ChannelKind::word);
}

void write_png(const std::filesystem::path& path, const Exposure& exposure, const Tone& tone) {
  Film straight = exposure.film;
  for (std::size_t i = 0; i < exposure.alpha.size(); ++i) {
    const float scale = exposure.alpha[i] > 0.0f ? 1.0f / exposure.alpha[i] : 0.0f;
    for (std::size_t c = 0; c < 3; ++c) straight.channels[3 * i + c] *= scale;
  }
  const Image8 colours = to_srgb8(straight, tone);
  std::vector<std::uint8_t> channels;
  channels.reserve(4 * exposure.alpha.size());
  for (std::size_t i = 0; i < exposure.alpha.size(); ++i) {
    channels.insert(channels.end(), {colours.channels[3 * i], colours.channels[3 * i + 1],
                                     colours.channels[3 * i + 2],
                                     static_cast<std::uint8_t>(255.0f * exposure.alpha[i] + 0.5f)});
  }
  write(path, {.width = colours.width,
               .height = colours.height,
               .count = 4,
               .attributes = {{"oiio:ColorSpace", "sRGB"},
                              // Light is given as PNG keeps it.
                              {"oiio:UnassociatedAlpha", 1}},
               .values = channels.data()});
}

void write_exr(const std::filesystem::path& path, const Film& film, ExrDepth depth) {
  // Without a date, OpenImageIO writes the time at which the file is made.
  write(path,
        {.width = film.width,
         .height = film.height,
         .stored = depth == ExrDepth::Half ? ChannelKind::half : ChannelKind::single,
         .attributes = {{"oiio:ColorSpace", "Linear"}, {"compression", "zip"}, {"DateTime", ""}},
         .given = ChannelKind::single,
         .values = film.channels.data()});
}

Image8 read_png8(const std::filesystem::path& path) {
  return read<std::uint8_t>(path, "png", ChannelKind::byte);
}

Image16 read_png16(const std::filesystem::path& path) {
  return read<std::uint16_t>(path, "png", ChannelKind::word);
}

Film read_exr(const std::filesystem::path& path) {
  return read<float>(path, "openexr", ChannelKind::single);
}

ImageSummary check_image(const std::filesystem::path& path) {
  const std::unique_ptr<ImageFile> file = opened(path, nullptr);
  const ImageLayout& layout = file->layout();
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
