#pragma once

namespace mien::render {

/// Pixels [x, x + width) × [y, y + height) of a picture.
struct Window {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;

  friend bool operator==(const Window&, const Window&) = default;
};

}  // namespace mien::render
