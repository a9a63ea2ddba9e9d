#include "render/image/resize.h"

#include <stdexcept>

#include <gtest/gtest.h>

namespace mien::render {
namespace {

Image8 uniform(int width, int height, std::uint8_t code) {
  Image8 image(width, height);
  image.channels.assign(image.channels.size(), code);
  return image;
}

TEST(Resized, KeepsAConstantPictureConstant) {
  for (const std::uint8_t code : {0, 1, 77, 254, 255}) {
    for (const auto& [width, height] : {std::pair{5, 3}, {17, 11}, {40, 31}, {1, 1}}) {
      EXPECT_EQ(resized(uniform(17, 11, code), width, height), uniform(width, height, code));
    }
  }
}

TEST(Resized, AveragesLightNotCodes) {
  Image8 chequers(64, 64);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x)
      for (int c = 0; c < 3; ++c) chequers.at(x, y)[c] = (x + y) % 2 ? 255 : 0;
  // Half the light of white is code 188; half the code would be 128.
  const Image8 small = resized(chequers, 8, 8);
  // Where the kernel does not reach over the edge.
  for (int y = 1; y < 7; ++y)
    for (int x = 1; x < 7; ++x) EXPECT_NEAR(small.at(x, y)[0], 188, 1);
}

TEST(Resized, KeepsThingsWhereTheyAre) {
  Image8 image = uniform(40, 20, 0);
  for (int y = 10; y < 20; ++y)
    for (int x = 0; x < 20; ++x) image.at(x, y)[0] = 255;  // lower left quarter is red
  const Image8 half = resized(image, 20, 10);
  EXPECT_EQ(half.at(4, 8)[0], 255);
  EXPECT_EQ(half.at(4, 8)[1], 0);
  EXPECT_EQ(half.at(4, 1)[0], 0);
  EXPECT_EQ(half.at(15, 8)[0], 0);
}

TEST(Resized, RefusesAnEmptySize) {
  EXPECT_THROW(resized(uniform(4, 4, 9), 0, 4), std::invalid_argument);
  EXPECT_THROW(resized(Image8{}, 4, 4), std::invalid_argument);
}

}  // namespace
}  // namespace mien::render
