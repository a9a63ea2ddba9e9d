#pragma once

#include "render/image/image.h"
#include "render/image/window.h"

namespace mien::render {

/// Rendered pixels: linear radiance, Rec.709 primaries, scene-referred (0.18 is mid grey, values
/// above 1 are allowed).
using Framebuffer = Image<float>;

/// Crops a list with `stride` values per pixel, of a picture `width` pixels wide, to a window.
template <class Value>
std::vector<Value> crop(const std::vector<Value>& values, int width, const Window& window,
                        std::size_t stride = 1) {
  std::vector<Value> cut;
  cut.reserve(stride * static_cast<std::size_t>(window.width) *
              static_cast<std::size_t>(window.height));
  for (int y = window.y; y < window.y + window.height; ++y) {
    const auto row = static_cast<std::ptrdiff_t>(
        stride * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(window.x)));
    const auto count = static_cast<std::ptrdiff_t>(stride * static_cast<std::size_t>(window.width));
    cut.insert(cut.end(), values.begin() + row, values.begin() + row + count);
  }
  return cut;
}

/// Crops a framebuffer to a window.
inline Framebuffer crop(const Framebuffer& framebuffer, const Window& window) {
  Framebuffer cut;
  cut.width = window.width;
  cut.height = window.height;
  cut.channels = crop(framebuffer.channels, framebuffer.width, window, 3);
  return cut;
}

/// A framebuffer with an alpha channel.
struct RenderTarget {
  Framebuffer color;         ///< multiplied by alpha (associated)
  std::vector<float> alpha;  ///< 0 … 1, one per pixel; empty if the background is shown
};

}  // namespace mien::render
