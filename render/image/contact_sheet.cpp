#include "render/image/contact_sheet.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace mien::render {

std::vector<int> evenly_spread(int frame_count, int count) {
  std::vector<int> frames;
  if (frame_count < 1 || count < 1) return frames;
  if (count == 1) return {(frame_count - 1) / 2};
  count = std::min(count, frame_count);
  if (count == 1) return {0};
  for (int i = 0; i < count; ++i) {
    frames.push_back(
        static_cast<int>(std::lround(static_cast<double>(i) * (frame_count - 1) / (count - 1))));
  }
  return frames;
}

Image8 contact_sheet(std::span<const Image8> pictures, const ContactSheet& layout) {
  if (pictures.empty()) throw std::invalid_argument("contact_sheet: no pictures");
  const int width = pictures.front().width;
  const int height = pictures.front().height;
  const int columns = std::clamp(static_cast<int>(pictures.size()), 1, layout.columns);
  const int rows = (static_cast<int>(pictures.size()) + columns - 1) / columns;
  Image8 sheet(layout.gap + columns * (width + layout.gap),
               layout.gap + rows * (height + layout.gap));
  for (std::size_t i = 0; i < sheet.channels.size(); ++i) {
    sheet.channels[i] = layout.background[i % 3];
  }
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const Image8& picture = pictures[i];
    if (picture.width != width || picture.height != height) {
      throw std::invalid_argument("contact_sheet: the pictures differ in size");
    }
    const int left = layout.gap + static_cast<int>(i) % columns * (width + layout.gap);
    const int top = layout.gap + static_cast<int>(i) / columns * (height + layout.gap);
    for (int y = 0; y < height; ++y) {
      std::copy_n(picture.at(0, y), 3 * width, sheet.at(left, top + y));
    }
  }
  return sheet;
}

}  // namespace mien::render
