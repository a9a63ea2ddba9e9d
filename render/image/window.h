#pragma once

#include <algorithm>

namespace mien::render {

/// Pixels [x, x + width) × [y, y + height) of a picture.
struct Window {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;

  int x_end() const { return x + width; }
  int y_end() const { return y + height; }

  friend bool operator==(const Window&, const Window&) = default;
};

/// Returns the pixels that both have. They must overlap.
inline Window intersection(const Window& a, const Window& b) {
  const int x = std::max(a.x, b.x), y = std::max(a.y, b.y);
  return {x, y, std::min(a.x_end(), b.x_end()) - x, std::min(a.y_end(), b.y_end()) - y};
}

}  // namespace mien::render
