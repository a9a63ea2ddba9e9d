#include <cstdlib>
#include <random>
#include <tuple>

#include <gtest/gtest.h>

#include "render/compare/picture_difference.h"

namespace mien::render {
namespace {

using Edges = std::tuple<int, int, int, int>;

Edges edges_of(const PicturePart& part) { return {part.x, part.y, part.width, part.height}; }

/// The rectangle around all pixels of a part that have one that differs within reach of them,
/// found by looking at every pair.
PicturePart found_one_by_one(const Image8& a, const Image8& b, const PicturePart& part, int reach) {
  int left = part.x + part.width, right = part.x, top = part.y + part.height, end = part.y;
  const auto differs = [&](int x, int y) {
    for (int c = 0; c < 3; ++c)
      if (a.at(x, y)[c] != b.at(x, y)[c]) return true;
    return false;
  };
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) {
      if (!differs(x, y)) continue;
      for (int py = part.y; py < part.y + part.height; ++py) {
        for (int px = part.x; px < part.x + part.width; ++px) {
          if (std::abs(px - x) > reach || std::abs(py - y) > reach) continue;
          left = std::min(left, px);
          right = std::max(right, px + 1);
          top = std::min(top, py);
          end = std::max(end, py + 1);
        }
      }
    }
  }
  return left < right ? PicturePart{left, top, right - left, end - top} : PicturePart{};
}

TEST(ChangedPart, HoldsAllThatDependsOnWhatDiffersAndNoRowOrColumnMore) {
  std::mt19937 random(3);
  const auto below = [&](int count) { return static_cast<int>(random() % unsigned(count)); };
  for (int round = 0; round < 300; ++round) {
    const Image8 a(31, 23);
    Image8 b = a;
    for (int n = below(4); n > 0; --n) b.at(below(31), below(23))[below(3)] += 1;
    PicturePart part{below(20), below(15), 1, 1};
    part.width += below(31 - part.x);
    part.height += below(23 - part.y);
    const int reach = below(6);
    EXPECT_EQ(edges_of(changed_part(a, b, part, reach)),
              edges_of(found_one_by_one(a, b, part, reach)));
  }
}

}  // namespace
}  // namespace mien::render
