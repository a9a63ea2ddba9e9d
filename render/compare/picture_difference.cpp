#include "render/compare/picture_difference.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <utility>

#include "render/image_files/image_files.h"

namespace mien::render {

namespace {

/// Grows a window so that it holds a pixel.
void include(Window& window, int x, int y) {
  if (window.width == 0) {
    window = {x, y, 1, 1};
    return;
  }
  const int right = std::max(window.x + window.width, x + 1);
  const int bottom = std::max(window.y + window.height, y + 1);
  window.x = std::min(window.x, x);
  window.y = std::min(window.y, y);
  window.width = right - window.x;
  window.height = bottom - window.y;
}

/// The first and last pixel of a stretch of a row that differ; first > last when none does.
std::pair<int, int> differing(const Image8& a, const Image8& b, int row, int left, int right) {
  constexpr std::ptrdiff_t channels = 3;
  const std::uint8_t *from = a.at(left, row), *to = from + channels * (right - left);
  const std::ptrdiff_t first = std::mismatch(from, to, b.at(left, row)).first - from;
  if (from + first == to) return {right, left};
  const std::uint8_t* of_b = b.at(left, row) + channels * (right - left);
  while (*--to == *--of_b) {
  }
  return {left + static_cast<int>(first / channels),
          left + static_cast<int>((to - from) / channels)};
}

}  // namespace

PictureDifference picture_difference(const Image8& a, const Image8& b, double limit) {
  require_same_size(a, b);
  PictureDifference found;
  double sum = 0.0, squares = 0.0;
  std::size_t at = 0;
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) {
      double most = 0.0;
      for (int c = 0; c < 3; ++c, ++at) {
        const double apart = std::abs(a.channels[at] - b.channels[at]) / 255.0;
        sum += apart;
        squares += apart * apart;
        most = std::max(most, apart);
        if (!(apart > found.largest)) continue;
        found.largest = apart;
        found.x = x;
        found.y = y;
        found.channel = c;
      }
      if (most == 0.0) continue;
      ++found.differing_pixels;
      if (most > limit) ++found.pixels_over_limit;
      include(found.changed, x, y);
    }
  }
  const double pixels = static_cast<double>(a.width) * a.height;
  found.mean = sum / (pixels * 3);
  found.rms = std::sqrt(squares / (pixels * 3));
  found.psnr_db = -20.0 * std::log10(found.rms);
  found.differing_share = static_cast<double>(found.differing_pixels) / pixels;
  found.over_limit_share = static_cast<double>(found.pixels_over_limit) / pixels;
  return found;
}

LibraryDifference library_difference(const Image8& a, const Image8& b, double limit) {
  require_same_size(a, b);
  const ImageComparison found = image_files().compare(
      {a.width, a.height, ChannelKind::byte, a.channels.data()},
      {b.width, b.height, ChannelKind::byte, b.channels.data()}, static_cast<float>(limit));
  return {.mean = found.mean,
          .rms = found.rms,
          .psnr_db = found.psnr_db,
          .largest = found.largest,
          .x = found.x,
          .y = found.y,
          .channel = found.channel,
          .failing_pixels = found.failing};
}

PicturePart changed_part(const Image8& a, const Image8& b, const PicturePart& part, int reach) {
  const int left = std::max(0, part.x - reach),
            right = std::min(a.width, part.x + part.width + reach);
  const int top = std::max(0, part.y - reach),
            end = std::min(a.height, part.y + part.height + reach);
  int first_x = right, last_x = left - 1, first_y = end, last_y = top - 1;
  for (int row = top; row < end; ++row) {
    const auto [first, last] = differing(a, b, row, left, right);
    if (first > last) continue;
    first_x = std::min(first_x, first);
    last_x = std::max(last_x, last);
    first_y = std::min(first_y, row);
    last_y = row;
  }
  if (first_y > last_y) return {};
  const int x = std::max(part.x, first_x - reach), y = std::max(part.y, first_y - reach);
  return {x, y, std::min(part.x + part.width, last_x + reach + 1) - x,
          std::min(part.y + part.height, last_y + reach + 1) - y};
}

}  // namespace mien::render
