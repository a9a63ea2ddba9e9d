#include "pipeline/production/film/film_frames.h"

#include <algorithm>
#include <type_traits>

#include <fmt/format.h>

#include "render/error.h"
#include "render/image/image_io.h"

namespace mien::pipeline {

namespace {

render::Image8 rounded_to_8_bits(const render::Image16& image) {
  render::Image8 result(image.width, image.height);
  std::transform(image.channels.begin(), image.channels.end(), result.channels.begin(),
                 [](std::uint16_t c) { return static_cast<std::uint8_t>((c + 128U) / 257U); });
  return result;
}

render::Image8 decoded(const std::filesystem::path& file, FrameFormat format,
                       const render::Tone& tone) {
  switch (format) {
    case FrameFormat::exr:
    case FrameFormat::layers:
      return render::to_srgb8(render::read_exr(file), tone);
    case FrameFormat::png16:
      return rounded_to_8_bits(render::read_png16(file));
    default:
      return render::read_png8(file);
  }
}

}  // namespace

std::string frame_name(FrameFormat format, int frame) {
  return fmt::format("{:05}.{}", frame,
                     format == FrameFormat::exr || format == FrameFormat::layers ? "exr" : "png");
}

void write_frame(const std::filesystem::path& file, const FramePicture& picture) {
  std::visit(
      [&]<class Picture>(const Picture& kept) {
        if constexpr (std::is_same_v<Picture, render::Framebuffer>) {
          render::write_exr(file, kept);
        } else if constexpr (std::is_same_v<Picture, render::Layers>) {
          render::write_layers(file, kept);
        } else {
          render::write_png(file, kept);
        }
      },
      picture);
}

render::Image8 read_frame(const std::filesystem::path& file, FrameFormat format,
                          const std::array<int, 2>& size, const render::Tone& tone) {
  render::Image8 image = decoded(file, format, tone);
  if (image.width != size[0] || image.height != size[1]) {
    throw render::Error(fmt::format("{}: has {} x {} pixels instead of {} x {}", file.string(),
                                    image.width, image.height, size[0], size[1]));
  }
  return image;
}

}  // namespace mien::pipeline
