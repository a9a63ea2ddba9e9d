#pragma once

#include "render/image/image.h"
#include "render/image/window.h"

namespace mien::render {

/// What the tracer exposes: linear radiance, Rec.709 primaries, scene-referred (0.18 is mid grey,
/// values above 1 are allowed).
using Film = Image<float>;

/// The pixels of a window, of a list with `stride` values a pixel, of a picture `width` pixels
/// wide.
template <class Value>
std::vector<Value> cut_out(const std::vector<Value>& values, int width, const Window& window,
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

/// Likewise of a film.
inline Film cut_out(const Film& film, const Window& window) {
  Film cut;
  cut.width = window.width;
  cut.height = window.height;
  cut.channels = cut_out(film.channels, film.width, window, 3);
  return cut;
}

/// A film, and how much of each pixel is covered where the background does not show.
struct Exposure {
  Film film;                 ///< multiplied by alpha (associated)
  std::vector<float> alpha;  ///< 0 … 1, one a pixel; empty where the background shows
};

}  // namespace mien::render
