#include "render/compare/perceptual_color.h"

#include <cmath>

#include <gtest/gtest.h>

namespace mien::render {
namespace {

// Columns of X, Y and Z of the primaries of sRGB, rounded as IEC 61966-2-1 has them, and its white.
TEST(PerceptualColor, TakesPrimariesToTheirPlacesInXyz) {
  const double xyz[3][3] = {
      {0.4124, 0.3576, 0.1805}, {0.2126, 0.7152, 0.0722}, {0.0193, 0.1192, 0.9505}};
  const double white[3] = {0.9505, 1.0, 1.0890};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      EXPECT_NEAR(white_relative_xyz()[i][j], xyz[i][j] / white[i], 2e-4);
}

TEST(PerceptualColor, MakesWhiteNeutralAndGreyNeutral) {
  for (const float grey : {0.0f, 0.2f, 1.0f}) {
    const OpponentColor color = opponent_from_linear(white_relative_xyz(), {grey, grey, grey});
    EXPECT_NEAR(color.y, grey, 2e-7f);
    EXPECT_NEAR(color.cx, 0.0f, 2e-7f);
    EXPECT_NEAR(color.cz, 0.0f, 2e-7f);
  }
}

TEST(PerceptualColor, ComesBackFromOpponentColors) {
  for (const LinearColor& color : {LinearColor{1.0f, 0.0f, 0.0f}, LinearColor{0.1f, 0.7f, 0.3f},
                                   LinearColor{0.0f, 0.0f, 1.0f}}) {
    const LinearColor back = linear_from_opponent(
        linear_from_white_relative_xyz(), opponent_from_linear(white_relative_xyz(), color));
    EXPECT_NEAR(back.r, color.r, 2e-6f);
    EXPECT_NEAR(back.g, color.g, 2e-6f);
    EXPECT_NEAR(back.b, color.b, 2e-6f);
  }
  const LinearColor cut = within_cube({-0.1f, 0.5f, 1.2f});
  EXPECT_EQ(cut.r, 0.0f);
  EXPECT_EQ(cut.g, 0.5f);
  EXPECT_EQ(cut.b, 1.0f);
}

// CIELAB of the primaries as widely published: red 53.24, 80.09, 67.20; green 87.73, −86.18, 83.18;
// blue 32.30, 79.19, −107.86; a and b then times 0.01 L.
TEST(PerceptualColor, HasTheLabOfNamedColorsWithTheHuntEffect) {
  const struct {
    LinearColor color;
    float l, a, b;
  } known[] = {{{1.0f, 0.0f, 0.0f}, 53.24f, 80.09f, 67.20f},
               {{0.0f, 1.0f, 0.0f}, 87.73f, -86.18f, 83.18f},
               {{0.0f, 0.0f, 1.0f}, 32.30f, 79.19f, -107.86f},
               {{1.0f, 1.0f, 1.0f}, 100.0f, 0.0f, 0.0f},
               {{0.0f, 0.0f, 0.0f}, 0.0f, 0.0f, 0.0f}};
  for (const auto& [color, l, a, b] : known) {
    const LabColor lab = hunt_lab_from_linear(white_relative_xyz(), color);
    EXPECT_NEAR(lab.l, l, 0.02f);
    EXPECT_NEAR(lab.a, 0.01f * l * a, 0.05f);
    EXPECT_NEAR(lab.b, 0.01f * l * b, 0.05f);
  }
}

TEST(PerceptualColor, HasALabCurveWhosePartsMeetWithOneSlope) {
  const float knee = 216.0f / 24389.0f;
  EXPECT_NEAR(lab_curve(knee), 6.0f / 29.0f, 1e-6f);
  EXPECT_NEAR(lab_curve(knee * 1.001f), lab_curve(knee), 1e-4f);
  EXPECT_NEAR(lab_curve(0.0f), 4.0f / 29.0f, 1e-7f);
}

TEST(PerceptualColor, MeasuresCityBlocksOfLightnessAndTheRest) {
  EXPECT_FLOAT_EQ(hyab({10.0f, 1.0f, 2.0f}, {17.0f, 4.0f, -2.0f}), 7.0f + 5.0f);
  // Green and blue: 55.43 of lightness; a −75.61 and 25.58, b 72.97 and −34.84.
  const double expected = std::pow(55.43 + std::hypot(-75.61 - 25.58, 72.97 + 34.84), 0.7);
  EXPECT_NEAR(largest_color_power(), expected, 0.02);
}

TEST(PerceptualColor, PutsTheKneeOfErrorsWhereThePaperHasIt) {
  const float largest = largest_color_power();
  EXPECT_EQ(redistributed(0.0f, largest), 0.0f);
  EXPECT_NEAR(redistributed(0.2f * largest, largest), 0.475f, 1e-6f);
  EXPECT_NEAR(redistributed(0.4f * largest, largest), 0.95f, 1e-6f);
  EXPECT_NEAR(redistributed(0.7f * largest, largest), 0.975f, 1e-6f);
  EXPECT_NEAR(redistributed(largest, largest), 1.0f, 1e-6f);
}

}  // namespace
}  // namespace mien::render
