#include "pipeline/production/film/film_presentation.h"

#include <vector>

#include <gtest/gtest.h>

namespace mien::pipeline {
namespace {

constexpr std::array<int, 2> shown_size = {64, 36};

/// What is shown of a film of white frames.
std::vector<render::Image8> shown(const Output& output, int film_frames) {
  Presenter presenter(output, film_frames);
  std::vector<render::Image8> pictures;
  for (int i = 0; i < film_frames; ++i) {
    presenter.take(blank_picture(shown_size, 255),
                   [&](const render::Image8& picture) { pictures.push_back(picture); });
  }
  EXPECT_EQ(static_cast<int>(pictures.size()), presenter.frames().all());
  return pictures;
}

Output output_of(const Presentation& presentation) {
  Output output;
  output.size = shown_size;
  output.fps = 10.0;
  output.presentation = presentation;
  return output;
}

TEST(Presentation, OfNothingShowsTheFilmItself) {
  const auto pictures = shown(output_of({}), 3);
  EXPECT_EQ(pictures, std::vector<render::Image8>(3, blank_picture(shown_size, 255)));
}

TEST(Presentation, ShowsCardCrossBlankFilmBlankInThisOrder) {
  const Presentation around{.card = "Look",
                            .card_seconds = 0.2,
                            .fixation_seconds = 0.3,
                            .fixation_size = 9,
                            .blank_before = 0.1,
                            .blank_after = 0.4,
                            .background = 0.0};
  const auto pictures = shown(output_of(around), 5);
  ASSERT_EQ(pictures.size(), 15u);
  EXPECT_EQ(pictures[1], card_picture(shown_size, 0, "Look"));
  EXPECT_EQ(pictures[2], fixation_picture(shown_size, 0, 9));
  EXPECT_EQ(pictures[4], fixation_picture(shown_size, 0, 9));
  EXPECT_EQ(pictures[5], blank_picture(shown_size, 0));
  EXPECT_EQ(pictures[6], blank_picture(shown_size, 255));
  EXPECT_EQ(pictures[10], blank_picture(shown_size, 255));
  EXPECT_EQ(pictures[11], blank_picture(shown_size, 0));
  EXPECT_EQ(pictures[14], blank_picture(shown_size, 0));
}

TEST(Presentation, GivesEachEyeItsOwnCardAndCross) {
  const Output output =
      output_of({.card = "Look", .card_seconds = 0.1, .fixation_seconds = 0.1, .fixation_size = 9});
  Presenter presenter(output, 1, 2);
  std::vector<render::Image8> pictures;
  presenter.take(blank_picture(shown_size, 255),
                 [&](const render::Image8& picture) { pictures.push_back(picture); });
  ASSERT_EQ(pictures.size(), 3u);
  const std::array<int, 2> half = {shown_size[0] / 2, shown_size[1]};
  const std::uint8_t grey = pictures[1].at(0, 0)[0];
  const render::Image8 card = card_picture(half, grey, "Look");
  const render::Image8 cross = fixation_picture(half, grey, 9);
  for (int y = 0; y < shown_size[1]; ++y) {
    for (int x = 0; x < shown_size[0]; ++x) {
      for (int c = 0; c < 3; ++c) {
        EXPECT_EQ(pictures[0].at(x, y)[c], card.at(x % half[0], y)[c]) << x << ' ' << y;
        EXPECT_EQ(pictures[1].at(x, y)[c], cross.at(x % half[0], y)[c]) << x << ' ' << y;
      }
    }
  }
}

TEST(Presentation, RoundsToWholeFrames) {
  const PresentationFrames frames = frames_of(
      {.fixation_seconds = 0.5, .blank_before = 0.049, .blank_after = 0.051, .fade_in = 9.0}, 10.0,
      7);
  EXPECT_EQ(frames.card, 0);
  EXPECT_EQ(frames.fixation, 5);
  EXPECT_EQ(frames.blank_before, 0);
  EXPECT_EQ(frames.blank_after, 1);
  EXPECT_EQ(frames.fade_in, 7);
  EXPECT_EQ(frames.all(), 13);
}

TEST(Presentation, FadesInLinearLightAndAlikeAtBothEnds) {
  const auto pictures = shown(output_of({.fade_in = 0.4, .fade_out = 0.4, .background = 0.0}), 10);
  std::vector<int> levels;
  for (const render::Image8& picture : pictures) levels.push_back(picture.channels[0]);
  // 1/8, 3/8, 5/8, 7/8 of the light; sRGB has half of it at 188.
  EXPECT_EQ(levels, (std::vector<int>{99, 165, 207, 240, 255, 255, 240, 207, 165, 99}));
}

TEST(Fixation, IsACrossInTheMiddle) {
  for (const std::array<int, 2> extent : {std::array<int, 2>{64, 36}, {65, 37}}) {
    const render::Image8 picture = fixation_picture(extent, 128, 18);
    int dark = 0;
    for (int y = 0; y < extent[1]; ++y) {
      for (int x = 0; x < extent[0]; ++x) {
        const int shade = picture.at(x, y)[0];
        EXPECT_EQ(shade, picture.at(extent[0] - 1 - x, y)[0]);
        EXPECT_EQ(shade, picture.at(x, extent[1] - 1 - y)[0]);
        dark += shade == 0;
      }
    }
    EXPECT_NEAR(dark, 2 * 18 * 2 - 4, 36);
    EXPECT_EQ(picture.at(extent[0] / 2, extent[1] / 2)[0], 0);
  }
}

TEST(Card, HasItsTextInTheMiddleAndInside) {
  for (const char* text : {"Look", "Two\nlines", "見てください",
                           "A very long line that would not fit if it were set at full size"}) {
    const render::Image8 picture = card_picture({320, 180}, 255, text);
    int left = 320, right = 0, top = 180, bottom = 0;
    for (int y = 0; y < 180; ++y) {
      for (int x = 0; x < 320; ++x) {
        if (picture.at(x, y)[1] > 128) continue;
        left = std::min(left, x);
        right = std::max(right, x);
        top = std::min(top, y);
        bottom = std::max(bottom, y);
      }
    }
    EXPECT_LT(left, right) << text;
    EXPECT_GT(left, 10);
    EXPECT_NEAR(left + right, 319, 6) << text;
    EXPECT_NEAR(top + bottom, 179, 8) << text;
  }
}

}  // namespace
}  // namespace mien::pipeline
