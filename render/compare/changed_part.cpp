#include "render/compare/changed_part.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace mien::render {
namespace {

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
