#include "pipeline/production/film/fixation_cross.h"

#include <algorithm>
#include <sstream>
#include <vector>

#include "pipeline/base/drawing/canvas.h"

namespace mien::pipeline {

namespace {

bool is_light(std::uint8_t grey) { return grey > 127; }

}  // namespace

render::Image8 blank_picture(std::array<int, 2> size, std::uint8_t grey) {
  render::Image8 picture(size[0], size[1]);
  std::fill(picture.channels.begin(), picture.channels.end(), grey);
  return picture;
}

render::Image8 fixation_picture(std::array<int, 2> size, std::uint8_t grey, int edge) {
  render::Image8 picture = blank_picture(size, grey);
  const std::uint8_t shade = is_light(grey) ? 0 : 255;
  // As many pixels on either side of the middle, which lies between pixels in even sizes.
  const auto bar = [&](int length, int extent) {
    length = std::min(length, extent);
    return length - (extent - length) % 2;
  };
  const auto fill = [&](int across, int down) {
    const int width = std::max(1, bar(across, size[0]));
    const int height = std::max(1, bar(down, size[1]));
    const int left = (size[0] - width) / 2;
    const int top = (size[1] - height) / 2;
    for (int y = top; y < top + height; ++y) std::fill_n(picture.at(left, y), 3 * width, shade);
  };
  const int thick = std::max(2, (edge + 4) / 9);
  fill(edge, thick);
  fill(thick, edge);
  return picture;
}

render::Image8 card_picture(std::array<int, 2> size, std::uint8_t grey, const std::string& text) {
  const double width = size[0];
  const double height = size[1];
  const auto canvas = Canvas::png(width, height, size[0]);
  const double level = grey / 255.0;
  canvas->fill(Box{0, 0, width, height}, Colour{level, level, level});
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  const double shade = is_light(grey) ? 0.0 : 1.0;
  TextStyle style{.size = height / 18.0, .colour = {shade, shade, shade}, .align = Align::centre};
  constexpr double spacing = 1.5;
  double widest = 0.0;
  for (const std::string& line : lines) {
    widest = std::max(widest, canvas->text_width(line, style));
  }
  const double tallest = spacing * style.size * static_cast<double>(lines.size());
  style.size *= std::min({1.0, 0.9 * width / std::max(widest, 1.0), 0.9 * height / tallest});
  const double step = spacing * style.size;
  // The middle of a line of text lies about a third of its size above its baseline.
  double baseline =
      0.5 * (height - step * static_cast<double>(lines.size() - 1)) + 0.35 * style.size;
  for (const std::string& line : lines) {
    canvas->text({0.5 * width, baseline}, line, style);
    baseline += step;
  }
  return canvas->finish_picture();
}

}  // namespace mien::pipeline
