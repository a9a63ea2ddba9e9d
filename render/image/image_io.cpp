#include "render/image/image_io.h"

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include <OpenImageIO/imageio.h>

#include "render/error.h"

namespace mien::render {
namespace {

using OIIO::ImageInput;
using OIIO::ImageOutput;
using OIIO::ImageSpec;
using OIIO::TypeDesc;

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& wrong) {
  throw Error(path.string() + ": " + wrong);
}

void write(const std::filesystem::path& path, const ImageSpec& spec, TypeDesc given,
           const void* channels) {
  const std::unique_ptr<ImageOutput> output = ImageOutput::create(path.string());
  if (!output) fail(path, OIIO::geterror());
  output->threads(1);
  if (!output->open(path.string(), spec) || !output->write_image(given, channels) ||
      !output->close())
    fail(path, output->geterror());
}

ImageSpec spec_of(int width, int height, TypeDesc stored, const char* color_space) {
  ImageSpec spec(width, height, 3, stored);
  spec.attribute("oiio:ColorSpace", color_space);
  return spec;
}

template <class Channel>
void write_png_of(const std::filesystem::path& path, const Image<Channel>& image, TypeDesc depth) {
  ImageSpec spec = spec_of(image.width, image.height, depth, "sRGB");
  // Rendered gradients gain little from more effort, and a frame is written many times as fast.
  if constexpr (sizeof(Channel) == 1) {
    // Few codes, each often repeated: unfiltered rows are smaller, and written three times as fast.
    constexpr int unfiltered = 8;  // PNG_FILTER_NONE
    spec.attribute("png:compressionLevel", 2);
    spec.attribute("png:filter", unfiltered);
  } else {
    spec.attribute("png:compressionLevel", 3);
  }
  write(path, spec, depth, image.channels.data());
}

std::unique_ptr<ImageInput> opened(const std::filesystem::path& path, const char* format) {
  std::unique_ptr<ImageInput> input = ImageInput::open(path.string());
  if (!input) fail(path, OIIO::geterror());
  if (format != nullptr && std::string(input->format_name()) != format)
    fail(path, std::string("is not ") + format + " but " + input->format_name());
  input->threads(1);
  return input;
}

template <class Channel>
Image<Channel> read(const std::filesystem::path& path, const char* format, TypeDesc wanted) {
  const std::unique_ptr<ImageInput> input = opened(path, format);
  const ImageSpec& spec = input->spec();
  if (spec.nchannels != 3) fail(path, "does not have three channels");
  if (format == std::string("png") && spec.format != wanted)
    fail(path, "has another number of bits a channel");
  Image<Channel> image(spec.width, spec.height);
  if (!input->read_image(0, 0, 0, 3, wanted, image.channels.data())) fail(path, input->geterror());
  return image;
}

}  // namespace

void write_png(const std::filesystem::path& path, const Image8& image) {
  write_png_of(path, image, TypeDesc::UINT8);
}

void write_png(const std::filesystem::path& path, const Image16& image) {
  write_png_of(path, image, TypeDesc::UINT16);
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
  ImageSpec spec(colours.width, colours.height, 4, TypeDesc::UINT8);
  spec.attribute("oiio:ColorSpace", "sRGB");
  // Light is given as PNG keeps it.
  spec.attribute("oiio:UnassociatedAlpha", 1);
  write(path, spec, TypeDesc::UINT8, channels.data());
}

void write_exr(const std::filesystem::path& path, const Film& film, ExrDepth depth) {
  const TypeDesc stored = depth == ExrDepth::Half ? TypeDesc::HALF : TypeDesc::FLOAT;
  ImageSpec spec = spec_of(film.width, film.height, stored, "Linear");
  spec.attribute("compression", "zip");
  spec.attribute("DateTime", "");  // else OpenImageIO writes the time at which it is made
  write(path, spec, TypeDesc::FLOAT, film.channels.data());
}

Image8 read_png8(const std::filesystem::path& path) {
  return read<std::uint8_t>(path, "png", TypeDesc::UINT8);
}

Image16 read_png16(const std::filesystem::path& path) {
  return read<std::uint16_t>(path, "png", TypeDesc::UINT16);
}

Film read_exr(const std::filesystem::path& path) {
  return read<float>(path, "openexr", TypeDesc::FLOAT);
}

ImageSummary check_image(const std::filesystem::path& path) {
  const std::unique_ptr<ImageInput> input = opened(path, nullptr);
  const ImageSpec& spec = input->spec();
  std::vector<float> channels(static_cast<std::size_t>(spec.image_pixels()) *
                              static_cast<std::size_t>(spec.nchannels));
  if (!input->read_image(0, 0, 0, spec.nchannels, TypeDesc::FLOAT, channels.data()))
    fail(path, input->geterror());
  ImageSummary summary;
  summary.format = input->format_name();
  summary.width = spec.width;
  summary.height = spec.height;
  summary.channels = spec.nchannels;
  summary.bits = static_cast<int>(8 * spec.format.size());
  summary.color_space = spec.get_string_attribute("oiio:ColorSpace");
  return summary;
}

std::string image_library() {
  return std::string("OpenImageIO ") + std::to_string(OIIO::openimageio_version() / 10000) + "." +
         std::to_string(OIIO::openimageio_version() / 100 % 100) + "." +
         std::to_string(OIIO::openimageio_version() % 100);
}

}  // namespace mien::render
