#include "pipeline/regression/comparison/frame_alignment.h"

#include <random>

#include <gtest/gtest.h>

namespace mien::pipeline {
namespace {

using Remarks = std::vector<std::string>;

/// A square that goes to the right by some pixels a frame, over a background that stands.
render::Image8 moving_square(int frame, int noise_seed = 0) {
  render::Image8 picture(320, 180);
  std::mt19937 random(static_cast<unsigned>(1000 * noise_seed + frame));
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const bool inside = x >= 10 + 3 * frame && x < 50 + 3 * frame && y >= 60 && y < 120;
      const int grain = noise_seed == 0 ? 0 : static_cast<int>(random() % 5) - 2;
      for (int c = 0; c < 3; ++c)
        picture.at(x, y)[c] = static_cast<std::uint8_t>((inside ? 220 : 60 + x / 4) + grain);
    }
  }
  return picture;
}

std::vector<Thumbnail> film(const std::vector<int>& frames, int noise_seed = 0) {
  std::vector<Thumbnail> thumbnails;
  for (const int frame : frames)
    thumbnails.push_back(thumbnail_of(moving_square(frame, noise_seed)));
  return thumbnails;
}

std::vector<int> count_to(int end) {
  std::vector<int> frames;
  for (int i = 0; i < end; ++i) frames.push_back(i);
  return frames;
}

TEST(FrameAlignment, PairsEachFrameOfTheSameFilm) {
  const auto frames = film(count_to(40));
  const FrameAlignment alignment = align(frames, frames);
  EXPECT_EQ(alignment.remarks, Remarks{});
  ASSERT_EQ(alignment.pairs.size(), 40U);
  for (int i = 0; i < 40; ++i) EXPECT_EQ(alignment.pairs[static_cast<std::size_t>(i)].now, i);
}

TEST(FrameAlignment, NoiseOfAnEncoderIsNoOtherFrame) {
  const FrameAlignment alignment = align(film(count_to(40), 1), film(count_to(40), 2));
  EXPECT_EQ(alignment.remarks, Remarks{});
  EXPECT_EQ(alignment.pairs.size(), 40U);
}

TEST(FrameAlignment, TellsADroppedFrame) {
  for (const int dropped : {0, 17, 39}) {
    std::vector<int> frames = count_to(40);
    frames.erase(frames.begin() + dropped);
    const FrameAlignment alignment = align(film(count_to(40)), film(frames));
    EXPECT_EQ(alignment.remarks, (Remarks{"frame " + std::to_string(dropped) + " is missing"}));
    EXPECT_EQ(alignment.pairs.size(), 39U);
  }
}

TEST(FrameAlignment, TellsARepeatedFrame) {
  std::vector<int> frames = count_to(40);
  frames.insert(frames.begin() + 20, 19);
  EXPECT_EQ(align(film(count_to(40)), film(frames)).remarks,
            (Remarks{"frame 20 repeats the previous one"}));
}

TEST(FrameAlignment, TellsOneThatRepeatsInAnothersPlace) {
  std::vector<int> frames = count_to(40);
  frames[21] = 20;
  EXPECT_EQ(align(film(count_to(40)), film(frames)).remarks,
            (Remarks{"frame 21 is missing", "frame 21 repeats the previous one"}));
}

TEST(FrameAlignment, TellsExchangedFrames) {
  std::vector<int> frames = count_to(40);
  std::swap(frames[10], frames[11]);
  EXPECT_EQ(align(film(count_to(40)), film(frames)).remarks,
            (Remarks{"frames 10 and 11 are swapped"}));
}

TEST(FrameAlignment, TellsAFilmThatBeginsLater) {
  std::vector<int> frames = count_to(40);
  frames.erase(frames.begin(), frames.begin() + 3);
  EXPECT_EQ(align(film(count_to(40)), film(frames)).remarks,
            (Remarks{"frames 0 to 2 are missing"}));
}

TEST(FrameAlignment, PairsFramesThatWereChangedInTheirPlaces) {
  for (const Remarks::size_type first : {0U, 17U, 37U}) {
    auto now = film(count_to(40));
    for (auto i = first; i < first + 3; ++i)
      for (std::uint8_t& channel : now[i]) channel = static_cast<std::uint8_t>(255 - channel);
    const FrameAlignment alignment = align(film(count_to(40)), now);
    EXPECT_EQ(alignment.remarks, Remarks{});
    ASSERT_EQ(alignment.pairs.size(), 40U);
    for (int i = 0; i < 40; ++i) EXPECT_EQ(alignment.pairs[static_cast<std::size_t>(i)].now, i);
  }
}

TEST(FrameAlignment, TellsADroppedFrameBesideChangedOnes) {
  std::vector<int> frames = count_to(40);
  frames.erase(frames.begin() + 30);
  auto now = film(frames);
  for (std::uint8_t& channel : now[5]) channel = static_cast<std::uint8_t>(255 - channel);
  const FrameAlignment alignment = align(film(count_to(40)), now);
  EXPECT_EQ(alignment.remarks, (Remarks{"frame 30 is missing"}));
  EXPECT_EQ(alignment.pairs.size(), 39U);
}

TEST(FrameAlignment, PairsStillsByTheirPlace) {
  const std::vector<int> still(12, 5);
  EXPECT_EQ(align(film(still), film(still)).pairs.size(), 12U);
}

// A table for aligning these would have 600 million entries.
TEST(FrameAlignment, PairsFramesByNumberWhereLengthsDifferTooMuch) {
  const std::vector<Thumbnail> longer(25'000, Thumbnail{7}), shorter(12'000, Thumbnail{7});
  const FrameAlignment cut = align(longer, shorter);
  EXPECT_EQ(cut.remarks,
            (Remarks{"12000 frames instead of 25000; too many to align, so frames of the "
                     "same number are compared"}));
  EXPECT_EQ(cut.pairs.size(), 12'000U);
  EXPECT_EQ(cut.missing.size(), 13'000U);
  EXPECT_EQ(cut.missing.front(), 12'000);
  EXPECT_TRUE(cut.added.empty());
  const FrameAlignment grown = align(shorter, longer);
  EXPECT_EQ(grown.remarks.size(), 1U);
  EXPECT_EQ(grown.pairs.back().now, 11'999);
  EXPECT_EQ(grown.added.size(), 13'000U);
}

}  // namespace
}  // namespace mien::pipeline
