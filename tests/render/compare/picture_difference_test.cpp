#include "render/compare/picture_difference.h"

#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <tuple>

#include <gtest/gtest.h>

#include "render/refusal.h"

namespace mien::render {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

Image8 picture() {
  Image8 image(20, 10);
  std::mt19937 random(8);
  for (std::uint8_t& channel : image.channels) channel = static_cast<std::uint8_t>(random() % 200);
  return image;
}

TEST(PictureDifference, OfEqualPicturesIsNone) {
  const PictureDifference found = picture_difference(picture(), picture());
  EXPECT_EQ(found.largest, 0.0);
  EXPECT_EQ(found.rms, 0.0);
  EXPECT_EQ(found.psnr_db, infinite);
  EXPECT_EQ(found.differing_pixels, 0);
  EXPECT_EQ(found.changed, Window{});
}

TEST(PictureDifference, TellsWhereAndHowMuch) {
  Image8 other = picture();
  other.at(4, 3)[1] += 51;
  other.at(9, 2)[0] += 2;
  other.at(9, 2)[2] += 2;
  other.at(6, 7)[2] += 2;
  const PictureDifference found = picture_difference(picture(), other, 0.01);
  EXPECT_DOUBLE_EQ(found.largest, 0.2);
  EXPECT_EQ(found.x, 4);
  EXPECT_EQ(found.y, 3);
  EXPECT_EQ(found.channel, 1);
  EXPECT_EQ(found.differing_pixels, 3);
  EXPECT_EQ(found.pixels_over_limit, 1);
  EXPECT_DOUBLE_EQ(found.differing_share, 3.0 / 200.0);
  EXPECT_DOUBLE_EQ(found.over_limit_share, 1.0 / 200.0);
  EXPECT_EQ(found.changed, (Window{4, 2, 6, 6}));
  EXPECT_DOUBLE_EQ(found.mean, (51.0 + 6.0) / 255.0 / 600.0);
  const double rms = std::sqrt((51.0 * 51.0 + 3 * 4.0) / 600.0) / 255.0;
  EXPECT_DOUBLE_EQ(found.rms, rms);
  EXPECT_DOUBLE_EQ(found.psnr_db, -20.0 * std::log10(rms));
}

TEST(PictureDifference, IsWhatOpenImageIoSays) {
  const Image8 a = picture();
  Image8 b = a;
  std::mt19937 random(4);
  for (std::uint8_t& channel : b.channels) channel += static_cast<std::uint8_t>(random() % 9);
  b.at(13, 8)[2] += 40;
  const PictureDifference own = picture_difference(a, b, 3.5 / 255.0);
  const LibraryDifference second = library_difference(a, b, 3.5 / 255.0);
  EXPECT_NEAR(own.largest, second.largest, 1e-6);
  EXPECT_EQ(own.x, second.x);
  EXPECT_EQ(own.y, second.y);
  EXPECT_EQ(own.channel, second.channel);
  EXPECT_NEAR(own.mean, second.mean, 1e-6);
  EXPECT_NEAR(own.rms, second.rms, 1e-6);
  EXPECT_NEAR(own.psnr_db, second.psnr_db, 1e-3);
  EXPECT_EQ(own.pixels_over_limit, second.failing_pixels);
  EXPECT_GT(second.failing_pixels, 10);
  EXPECT_LT(second.failing_pixels, 200);
}

TEST(PictureDifference, IsRefusedForOtherSizes) {
  EXPECT_EQ(test::refusal_of([] { picture_difference(Image8(4, 3), Image8(5, 3)); }),
            "the pictures differ in size: 4 x 3 and 5 x 3 pixels");
  EXPECT_EQ(test::refusal_of([] { library_difference(Image8(4, 3), Image8(5, 3)); }),
            "the pictures differ in size: 4 x 3 and 5 x 3 pixels");
}

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
