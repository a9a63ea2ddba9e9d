#include "render/video/colour_table.h"

#include <cmath>

#include <gtest/gtest.h>

#include "render/video_frames.h"

namespace mien::render {
namespace {

Image8 indexed_and_back(ColourTable& table, const Image8& frame) {
  std::vector<std::uint32_t> entries(256);
  table.copy_entries(entries.data());
  std::vector<std::uint8_t> numbers(frame.channels.size() / 3);
  table.index(frame, numbers.data(), frame.width);
  Image8 result(frame.width, frame.height);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    EXPECT_NE(numbers[i], 255);
    const std::uint32_t entry = entries[numbers[i]];
    result.channels[3 * i] = static_cast<std::uint8_t>(entry >> 16);
    result.channels[3 * i + 1] = static_cast<std::uint8_t>(entry >> 8);
    result.channels[3 * i + 2] = static_cast<std::uint8_t>(entry);
  }
  return result;
}

ColourTable table_of(const Image8& frame) {
  ColourHistogram histogram;
  histogram.add(frame);
  return ColourTable(histogram);
}

TEST(ColourTable, KeepsAFewColoursExactly) {
  Image8 frame(40, 30);
  for (int i = 0; i < 1200; ++i) {
    for (int c = 0; c < 3; ++c) {
      frame.channels[static_cast<std::size_t>(3 * i + c)] =
          static_cast<std::uint8_t>(17 + 23 * (i % 7) + 5 * c);
    }
  }
  ColourTable table = table_of(frame);
  EXPECT_EQ(table.size(), 7);
  EXPECT_EQ(indexed_and_back(table, frame), frame);
}

TEST(ColourTable, KeepsTheMeanOfAGradientByDither) {
  // Far more colours than entries: single pixels are off, their mean over 16 × 16 much less so.
  const Image8 frame = test::smooth_frame(256, 256, 0);
  ColourTable table = table_of(frame);
  EXPECT_EQ(table.size(), 255);
  const Image8 shown = indexed_and_back(table, frame);
  double of_pixels = 0.0;
  double of_blocks = 0.0;
  for (int block = 0; block < 256; ++block) {
    for (int c = 0; c < 3; ++c) {
      double sum = 0.0;
      for (int i = 0; i < 256; ++i) {
        const int x = 16 * (block % 16) + i % 16;
        const int y = 16 * (block / 16) + i / 16;
        const double difference = shown.at(x, y)[c] - frame.at(x, y)[c];
        sum += difference;
        of_pixels += difference * difference;
      }
      of_blocks += sum * sum / 256.0;
    }
  }
  EXPECT_LT(std::sqrt(of_blocks / of_pixels), 0.5);
  EXPECT_LT(std::sqrt(of_pixels / (3 * 65536)), 16.0);
}

TEST(ColourTable, OfBlackAloneIsBlack) {
  const Image8 frame(8, 8);
  ColourTable table = table_of(frame);
  EXPECT_EQ(table.size(), 1);
  EXPECT_EQ(indexed_and_back(table, frame), frame);
}

}  // namespace
}  // namespace mien::render
