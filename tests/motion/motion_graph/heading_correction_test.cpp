#include "motion/motion_graph/heading_correction.h"

#include <array>

#include <gtest/gtest.h>

namespace mien::motion {
namespace {

constexpr double degree = radians_per_degree;

/// Ten seconds at 30 frames a second that face one way.
WalkHeadings facing_on(double radians) {
  WalkHeadings headings;
  for (int f = 0; f < 300; ++f) {
    headings.seconds.push_back(f / 30.0);
    headings.facings.push_back(radians);
  }
  return headings;
}

TEST(HeadingCorrection, AddsWhatIsMissingSmoothlyAndKeepsIt) {
  const std::array<HeadingGoal, 2> goals = {HeadingGoal{4.0, 10.0 * degree, 0.5, 0},
                                            HeadingGoal{8.0, 10.0 * degree, 0.5, 1}};
  const HeadingCorrection spread = correct_headings(facing_on(0.0), goals);
  EXPECT_NEAR(spread.added.front(), 0.0, 1e-12);
  EXPECT_NEAR(spread.added[115], 10.0 * degree, 1e-9);
  EXPECT_NEAR(spread.added.back(), 10.0 * degree, 1e-9);
  for (std::size_t f = 1; f < spread.added.size(); ++f)
    EXPECT_LT(spread.added[f] - spread.added[f - 1], 0.2 * degree);
  EXPECT_NEAR(spread.missing[0], 0.0, 1e-12);
  EXPECT_NEAR(spread.missing[1], 0.0, 1e-12);
}

TEST(HeadingCorrection, TellsWhatIsTooMuch) {
  const std::array<HeadingGoal, 1> goal = {HeadingGoal{9.0, 90.0 * degree, 0.5, 0}};
  const HeadingCorrection spread = correct_headings(facing_on(0.0), goal);
  EXPECT_NEAR(spread.added.back(), 25.0 * degree, 1e-9);
  EXPECT_NEAR(spread.missing[0], 65.0 * degree, 1e-9);
}

TEST(HeadingCorrection, TurnsNoFasterThanFeetFollow) {
  const std::array<HeadingGoal, 1> goal = {HeadingGoal{1.0, -20.0 * degree, 0.2, 0}};
  const HeadingCorrection spread = correct_headings(facing_on(0.0), goal);
  EXPECT_NEAR(spread.added.back(), -12.0 * 0.8 * degree, 1e-9);
}

TEST(HeadingCorrection, GoesTheShorterWay) {
  const std::array<HeadingGoal, 1> goal = {HeadingGoal{8.0, 175.0 * degree, 0.5, 0}};
  const HeadingCorrection spread = correct_headings(facing_on(-175.0 * degree), goal);
  EXPECT_NEAR(spread.added.back(), -10.0 * degree, 1e-9);
}

}  // namespace
}  // namespace mien::motion
