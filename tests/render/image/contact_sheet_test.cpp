#include "render/image/contact_sheet.h"

#include <stdexcept>

#include <gtest/gtest.h>

namespace mien::render {
namespace {

Image8 constant(int width, int height, std::uint8_t code) {
  Image8 image(width, height);
  image.channels.assign(image.channels.size(), code);
  return image;
}

TEST(EvenlySpread, IncludesBothEnds) {
  EXPECT_EQ(evenly_spread(11, 3), (std::vector<int>{0, 5, 10}));
  EXPECT_EQ(evenly_spread(100, 4), (std::vector<int>{0, 33, 66, 99}));
}

TEST(EvenlySpread, GivesNoFrameTwice) {
  EXPECT_EQ(evenly_spread(3, 8), (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(evenly_spread(1, 8), (std::vector<int>{0}));
  EXPECT_EQ(evenly_spread(0, 8), (std::vector<int>{}));
}

TEST(EvenlySpread, GivesTheMiddleWhenOneIsWanted) {
  EXPECT_EQ(evenly_spread(11, 1), (std::vector<int>{5}));
}

TEST(ContactSheet, LaysPicturesOutRowByRowFromTheTopLeft) {
  const std::vector<Image8> pictures{constant(5, 3, 10), constant(5, 3, 20), constant(5, 3, 30)};
  const Image8 sheet = contact_sheet(pictures, {.columns = 2, .gap = 4, .background = {1, 2, 3}});
  ASSERT_EQ(sheet.width, 4 + 5 + 4 + 5 + 4);
  ASSERT_EQ(sheet.height, 4 + 3 + 4 + 3 + 4);
  for (int y = 0; y < sheet.height; ++y) {
    for (int x = 0; x < sheet.width; ++x) {
      const bool in_left = x >= 4 && x < 9, in_right = x >= 13 && x < 18;
      const bool in_top = y >= 4 && y < 7, in_bottom = y >= 11 && y < 14;
      const int shown = in_top && in_left      ? 10
                        : in_top && in_right   ? 20
                        : in_bottom && in_left ? 30
                                               : 0;
      for (int c = 0; c < 3; ++c) EXPECT_EQ(sheet.at(x, y)[c], shown ? shown : c + 1);
    }
  }
}

TEST(ContactSheet, IsNoWiderThanItsPictures) {
  const std::vector<Image8> one{constant(5, 3, 10)};
  EXPECT_EQ(contact_sheet(one, {.columns = 4, .gap = 1}).width, 7);
}

TEST(ContactSheet, RefusesNoPicturesAndMixedSizes) {
  EXPECT_THROW(contact_sheet({}), std::invalid_argument);
  const std::vector<Image8> mixed{constant(5, 3, 10), constant(5, 4, 10)};
  EXPECT_THROW(contact_sheet(mixed), std::invalid_argument);
}

}  // namespace
}  // namespace mien::render
