#include "motion/procedural/walk_style.h"

#include <gtest/gtest.h>

namespace mien::motion {
namespace {

TEST(WalkStyle, OrdinaryWalkAtTheUsualPaceIsTheDefault) {
  const WalkStyle normal;
  const WalkStyle style = ordinary_walk(normal.speed_m_s, normal.cadence_steps_min);
  EXPECT_DOUBLE_EQ(style.stance_share, normal.stance_share);
  EXPECT_DOUBLE_EQ(style.heel_rise_share, normal.heel_rise_share);
  EXPECT_DOUBLE_EQ(style.heel_strike_deg, normal.heel_strike_deg);
  EXPECT_DOUBLE_EQ(style.toe_off_deg, normal.toe_off_deg);
  EXPECT_DOUBLE_EQ(style.bounce_m, normal.bounce_m);
  EXPECT_DOUBLE_EQ(style.pelvis_rotation_deg, normal.pelvis_rotation_deg);
  EXPECT_DOUBLE_EQ(style.arm_swing_deg, normal.arm_swing_deg);
  EXPECT_DOUBLE_EQ(style.elbow_flexion_deg, normal.elbow_flexion_deg);
}

TEST(WalkStyle, FasterWalksHaveShorterStanceAndWiderArmSwing) {
  const WalkStyle slow = ordinary_walk(0.8, 85.0);
  const WalkStyle fast = ordinary_walk(1.9, 130.0);
  EXPECT_GT(slow.stance_share, fast.stance_share + 0.03);
  EXPECT_LT(slow.arm_swing_deg, 0.8 * fast.arm_swing_deg);
  EXPECT_LT(slow.bounce_m, fast.bounce_m);
  EXPECT_LT(slow.heel_strike_deg, fast.heel_strike_deg);
}

TEST(WalkStyle, StepLengthIsSpeedByCadence) {
  EXPECT_DOUBLE_EQ(step_length_m(WalkStyle{.speed_m_s = 1.4, .cadence_steps_min = 120.0}), 0.7);
}

TEST(WalkStyle, BounceGrowsWithTheSquareOfTheStep) {
  EXPECT_NEAR(natural_bounce_m(0.8), 4.0 * natural_bounce_m(0.4), 1e-12);
}

}  // namespace
}  // namespace mien::motion
