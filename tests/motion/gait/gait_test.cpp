#include "motion/gait/gait.h"

#include <gtest/gtest.h>

#include "motion/gait/loop.h"
#include "motion/skeleton/mirror.h"
#include "motion/skeleton/straighten.h"
#include "motion/synthetic_walk.h"

namespace mien::motion {
namespace {

using namespace mien::test;

constexpr std::array<double, 7> known_keytimes = {0.0, 0.1, 0.3, 0.5, 0.6, 0.8, 1.0};

TEST(Gait, OfTheSyntheticWalkerHasItsKeytimes) {
  const std::vector<GaitCycle> cycles = gait_cycles(synthetic_clip(steady_walk(1.2, 6.0)));
  ASSERT_GE(cycles.size(), 4u);
  for (const GaitCycle& cycle : cycles) {
    EXPECT_TRUE(cycle.starts_left);
    EXPECT_NEAR(
        cycle.start_frame % 100 > 50 ? cycle.start_frame % 100 - 100 : cycle.start_frame % 100, 0,
        2);
    for (size_t k = 0; k < 7; ++k) EXPECT_NEAR(cycle.keytimes[k], known_keytimes[k], 0.03) << k;
    EXPECT_NEAR(cycle.speed_m_s, 1.2, 0.02);
    EXPECT_FALSE(cycle.has_flight);
    EXPECT_GT(cycle.steadiness, 0.9);
    EXPECT_TRUE(cycle.warnings.empty());
  }
}

TEST(Gait, ChoosesASteadyStraightCycleOfALongTake) {
  const SyntheticWalk walk = long_take();
  const Clip clip = synthetic_clip(walk);
  const auto cycle = steadiest_cycle(clip);
  ASSERT_TRUE(cycle);
  // Steady and straight between seconds 3 and 8; the slow filters see a little beyond.
  EXPECT_GE(cycle->start_frame, 290);
  EXPECT_LE(cycle->end_frame, 800);
  EXPECT_GT(cycle->steadiness, 0.8);
  double worst = 1.0;
  for (const GaitCycle& other : gait_cycles(clip)) {
    worst = std::min(worst, other.steadiness);
    const bool turns = other.start_frame > 820 && other.end_frame < 1080;
    if (turns) {
      EXPECT_LT(other.steadiness, 0.5) << other.start_frame;
    }
  }
  EXPECT_LT(worst, 0.3);
}

TEST(Gait, ExchangesSidesInTheMirror) {
  const Clip clip = synthetic_clip(steady_walk(1.2, 4.0));
  const std::vector<GaitCycle> cycles = gait_cycles(clip);
  const std::vector<GaitCycle> seen = gait_cycles(mirrored(clip));
  ASSERT_FALSE(cycles.empty());
  ASSERT_FALSE(seen.empty());
  // The mirror's left strikes are the right ones: half a stride away.
  const double shift = std::abs(seen.front().left_strike - cycles.front().left_strike);
  EXPECT_NEAR(shift, 50, 1.5);
}

TEST(Gait, IsCutAtRightStrikesWhereOnlyTheyComeTwice) {
  SyntheticWalk walk = steady_walk(1.2, 1.4);
  for (double& distance : walk.distance) distance += 0.45;  // right strikes at frames 12.5, 112.5
  const auto cycle = steadiest_cycle(synthetic_clip(walk));
  ASSERT_TRUE(cycle);
  EXPECT_FALSE(cycle->starts_left);
  EXPECT_NEAR(cycle->start_frame, 13, 2);
  EXPECT_NEAR(cycle->left_strike, 62.5, 2);
  for (size_t k = 0; k < 7; ++k) EXPECT_NEAR(cycle->keytimes[k], known_keytimes[k], 0.03) << k;
}

TEST(Gait, OfATakeOfOneCycleIsCutWhereThePoseRepeats) {
  SyntheticWalk walk = steady_walk(1.2, 1.03);
  for (double& distance : walk.distance) distance += 0.3;  // left 75, right 25 frames in
  const auto cycle = steadiest_cycle(synthetic_clip(walk));
  ASSERT_TRUE(cycle);
  EXPECT_NEAR(cycle->end_frame - cycle->start_frame, 100, 1);
  for (size_t k = 0; k < 7; ++k) EXPECT_NEAR(cycle->keytimes[k], known_keytimes[k], 0.04) << k;
  EXPECT_FALSE(cycle->warnings.empty());
}

TEST(Gait, OfATakeOfOneStepIsThatStepAndItsMirrorImage) {
  SyntheticWalk walk = steady_walk(1.2, 0.85);
  for (double& distance : walk.distance) distance += 0.42;  // right strike at 15, left at 65
  const auto cycle = steadiest_cycle(synthetic_clip(walk));
  ASSERT_TRUE(cycle);
  EXPECT_TRUE(cycle->is_half);
  EXPECT_NEAR(cycle->end_frame - cycle->start_frame, 50, 2);
  EXPECT_NEAR(cycle->keytimes.back(), 1.0, 0.04);
  EXPECT_NEAR(cycle->keytimes[3], 0.5, 0.03);
}

TEST(Gait, OfStandingIsNone) {
  SyntheticWalk still;
  still.distance.assign(300, 0.3);
  EXPECT_TRUE(gait_cycles(synthetic_clip(still)).empty());
  EXPECT_FALSE(steadiest_cycle(synthetic_clip(still)));
}

TEST(Gait, OfABodyThatTwistsOverStandingFeetIsNone) {
  // Seen from the pelvis, the feet go to and fro as in walking.
  Clip clip = synthetic_clip(steady_walk(0.0, 8.0));
  for (int t = 0; t < clip.frame_count(); ++t) {
    Pose& pose = clip.poses[t];
    const double turn = 0.5 * std::sin(2 * pi * t / 100.0);
    pose.rotations[Pelvis] = about(Vec3::UnitY(), turn);
    for (const bool left : {true, false}) {
      put_leg(pose, clip.body, left ? LeftHip : RightHip,
              {Vec3(left ? 0.09 : -0.09, 0.08, left ? 0.1 : -0.1), 0.0});
    }
  }
  EXPECT_TRUE(gait_cycles(clip).empty());
  EXPECT_FALSE(steadiest_cycle(clip));
}

TEST(CycleOfLoop, SpansTheWholeLoop) {
  const Clip clip = synthetic_clip(steady_walk(1.2, 4.0));
  const Clip loop = straightened(closed_loop(clip, 130, 230));
  for (const Clip& shown : {loop, in_place(loop)}) {
    const auto cycle = cycle_of_loop(shown);
    ASSERT_TRUE(cycle);
    EXPECT_EQ(cycle->start_frame, 0);
    EXPECT_EQ(cycle->end_frame, 100);
    EXPECT_NEAR(cycle->left_strike, 70, 2);
    EXPECT_DOUBLE_EQ(cycle->keytimes.back(), 1.0);
    for (size_t k = 0; k < 7; ++k) EXPECT_NEAR(cycle->keytimes[k], known_keytimes[k], 0.03) << k;
  }
}

}  // namespace
}  // namespace mien::motion
