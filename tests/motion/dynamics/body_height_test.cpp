#include "motion/dynamics/body_height.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "motion/biomechanics/body_dynamics.h"
#include "motion/jumping_figure.h"
#include "motion/modify/path_measures.h"
#include "motion/procedural/walker.h"

namespace mien::motion {
namespace {

using namespace mien::test;

std::vector<double> accelerations(const std::vector<double>& heights, double rate) {
  std::vector<double> result(heights.size(), 0.0);
  for (size_t f = 1; f + 1 < heights.size(); ++f)
    result[f] = (heights[f + 1] - 2.0 * heights[f] + heights[f - 1]) * rate * rate;
  return result;
}

TEST(BodyHeight, FallsWithGravityInFlightWhateverItDidBefore) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> phase(0.0, 6.0);
  for (const double rate : {30.0, 60.0, 120.0}) {
    std::vector<double> heights;
    const double first = phase(random), second = phase(random);
    for (int f = 0; f <= static_cast<int>(3.0 * rate); ++f)
      heights.push_back(1.0 + 0.05 * std::sin(first + 5.0 * f / rate) +
                        0.02 * std::sin(second + 11.0 * f / rate));
    const std::vector<Airborne> flights = {
        {static_cast<int>(0.5 * rate), static_cast<int>(rate)},
        {static_cast<int>(1.8 * rate), static_cast<int>(2.1 * rate)}};
    const std::vector<double> fallen = ballistic(heights, flights, rate, false);
    const std::vector<double> bend = accelerations(fallen, rate);
    for (const Airborne& flight : flights) {
      EXPECT_EQ(fallen[static_cast<size_t>(flight.take_off)],
                heights[static_cast<size_t>(flight.take_off)]);
      for (int f = flight.take_off + 1; f < flight.landing; ++f)
        EXPECT_NEAR(bend[static_cast<size_t>(f)], -gravity, 1e-6);
      // The speed does not leap: no acceleration beyond what joins it within a fifth of a second.
      for (const int edge : {flight.take_off, flight.landing})
        EXPECT_LT(std::abs(bend[static_cast<size_t>(edge)]), 60.0) << rate;
    }
  }
}

TEST(BodyHeight, KeepsAJumpThatIsBallisticAlready) {
  for (const bool loops : {true, false}) {
    JumpingFigure figure;
    std::vector<double> heights;
    const int frames = static_cast<int>(figure.period() * 100.0 + 0.5) * (loops ? 1 : 3);
    for (int f = 0; f < frames; ++f) heights.push_back(figure.rise(f / 100.0));
    std::vector<Airborne> flights = {{44, 80}};
    if (!loops) flights = {{44, 80}, {124, 160}};
    const std::vector<double> same = ballistic(heights, flights, 100.0, loops);
    for (size_t f = 0; f < heights.size(); ++f) EXPECT_NEAR(same[f], heights[f], 2e-5) << f;
  }
}

TEST(BodyHeight, IsReachedByTheLegsWithFeetInPlace) {
  const Clip clip = jumping({}, true);
  const std::vector<FootPlant> plants = {{true, 0, 44}, {false, 0, 44}};
  std::vector<double> heights = body_heights(clip);
  for (size_t f = 0; f < heights.size(); ++f) heights[f] -= 0.03;
  const Clip lower = with_body_heights(clip, heights, plants, {{44, 80}}, FeetStay::planted);
  const std::vector<double> reached = body_heights(lower);
  // The legs' masses bend with them, so that speeds do not quite fit without being joined.
  heights = ballistic(heights, {{44, 80}}, 100.0, true);
  const auto before = joint_paths(clip), after = joint_paths(lower);
  for (size_t f = 0; f < heights.size(); ++f) {
    EXPECT_NEAR(reached[f], heights[f], 3e-4) << f;
    if (f > 44) continue;
    for (const BodyJoint joint : {LeftAnkle, RightAnkle, LeftToe, RightToe})
      EXPECT_LT((before[f][joint] - after[f][joint]).norm(), 1e-6);
  }
  const std::vector<double> bend = accelerations(reached, 100.0);
  for (size_t f = 45; f < 79; ++f) EXPECT_NEAR(bend[f], -gravity, 1e-6);
}

TEST(BodyHeight, IsLoweredToWhereLegsReach) {
  const Clip clip = walk({}, 60.0, standard_body()).clip;
  const int last = clip.frame_count() - 1;
  const std::vector<FootPlant> plants = {{true, 0, last}};
  std::vector<double> heights = body_heights(clip);
  for (double& height : heights) height += 0.2;
  const Clip higher = with_body_heights(clip, heights, plants, {}, FeetStay::all);
  const auto before = joint_paths(clip), after = joint_paths(higher);
  for (size_t f = 0; f < before.size(); ++f) {
    for (const BodyJoint joint : {LeftAnkle, RightAnkle})
      EXPECT_LT((before[f][joint] - after[f][joint]).norm(), 1e-3) << f;
  }
}

}  // namespace
}  // namespace mien::motion
