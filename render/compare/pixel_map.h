#pragma once

#include <cstddef>
#include <vector>

namespace mien::render {

/// One number per pixel, in rows from top to bottom.
struct PixelMap {
  int width = 0;
  int height = 0;
  std::vector<float> values;

  PixelMap() = default;
  PixelMap(int w, int h)
      : width(w), height(h), values(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}

  float* row(int y) {
    return values.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
  }
  const float* row(int y) const {
    return values.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
  }
  float at(int x, int y) const { return row(y)[x]; }

  bool operator==(const PixelMap&) const = default;
};

}  // namespace mien::render
