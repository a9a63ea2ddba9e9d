#include "motion/measures/features/motion_measures.h"

#include <gtest/gtest.h>

#include "motion/procedural/walker.h"

namespace mien::motion {
namespace {

MotionMeasures of(const WalkStyle& style) { return measure(walk(style, 60.0, standard_body())); }

TEST(MotionMeasures, OfAnOrdinaryWalkIsWhatWasAskedFor) {
  const MotionMeasures m = of(WalkStyle{});
  EXPECT_NEAR(m.speed_m_s, 1.35, 0.01);
  EXPECT_NEAR(m.tempo_hz, 112.0 / 120.0, 0.02);
  EXPECT_NEAR(m.bounce_m, 0.043, 0.008);
  EXPECT_NEAR(m.lift_share, m.bounce_m / (m.bounce_m + m.sway_m), 1e-12);
}

TEST(MotionMeasures, EachMeasureFollowsItsOwnKnob) {
  const MotionMeasures usual = of(WalkStyle{});
  EXPECT_GT(of({.trunk_rotation_deg = 12.0}).trunk_turn_rad, 1.2 * usual.trunk_turn_rad);
  EXPECT_GT(of({.stance_knee_deg = 20.0}).least_knee_rad, usual.least_knee_rad + 0.1);
  EXPECT_LT(of({.sway_m = 0.09}).lift_share, usual.lift_share - 0.1);
  EXPECT_GT(of({.neck_flexion_deg = 30.0}).head_pitch_rad, usual.head_pitch_rad + 0.1);
  EXPECT_GT(of({.arm_swing_deg = 60.0}).hand_range_m, 1.2 * usual.hand_range_m);
  EXPECT_GT(of({.elbow_flexion_deg = 80.0}).elbow_flexion_rad, usual.elbow_flexion_rad + 0.5);
}

}  // namespace
}  // namespace mien::motion
