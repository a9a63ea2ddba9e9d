#include "pipeline/manifest/output.h"

#include <cmath>

namespace mien::pipeline {

std::array<int, 2> Output::whole_size() const {
  return {static_cast<int>(std::lround(scale * size[0])),
          static_cast<int>(std::lround(scale * size[1]))};
}

std::optional<render::Window> Output::window() const {
  if (!crop) return std::nullopt;
  const auto scaled = [&](int pixels) { return static_cast<int>(std::lround(scale * pixels)); };
  const auto [left, top, width, height] = *crop;
  const int x = scaled(left), y = scaled(top);
  return render::Window{x, y, scaled(left + width) - x, scaled(top + height) - y};
}

std::array<int, 2> Output::shown_size() const {
  if (!crop) return whole_size();
  const render::Window shown = *window();
  return {shown.width, shown.height};
}

}  // namespace mien::pipeline
