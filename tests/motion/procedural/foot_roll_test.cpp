#include "motion/procedural/foot_roll.h"

#include <cmath>

#include <gtest/gtest.h>

namespace mien::motion {
namespace {

class FootRoll : public testing::Test {
 protected:
  FootShape shape = foot_shape(standard_body(), LeftAnkle);
  WalkStyle style;
  Vec3 print{0.05, 0.0, 0.4};
  double yaw = 0.1;

  FootPose at(double phase) const { return stance_foot(shape, style, print, yaw, phase); }
  Vec3 point(double phase, const Vec3& in_foot) const {
    const FootPose foot = at(phase);
    return foot.ankle + foot_rotation(foot) * in_foot;
  }
};

TEST_F(FootRoll, SoleIsFlatInMidStance) {
  const FootPose foot = at(0.25);
  EXPECT_EQ(foot.pitch, 0.0);
  EXPECT_NEAR(foot.ankle.x(), print.x(), 1e-12);
  EXPECT_NEAR(foot.ankle.y(), shape.ankle_height, 1e-12);
  EXPECT_NEAR(foot.ankle.z(), print.z(), 1e-12);
}

TEST_F(FootRoll, TurnsAboutTheHeelThenAboutTheBallWithoutSlipping) {
  const Vec3 heel = point(0.2, shape.heel);
  const Vec3 ball = point(0.2, shape.ball);
  for (int i = 0; i <= 100; ++i) {
    const double phase = style.stance_share * i / 100.0;
    const FootPose foot = at(phase);
    if (foot.pitch >= 0.0) {
      EXPECT_LT((point(phase, shape.heel) - heel).norm(), 1e-12) << phase;
    }
    if (foot.pitch <= 0.0) {
      EXPECT_LT((point(phase, shape.ball) - ball).norm(), 1e-12) << phase;
    }
    EXPECT_NEAR(foot.pitch + foot.toe_extension, std::max(0.0, foot.pitch), 1e-12);
  }
  EXPECT_NEAR(heel.y(), 0.0, 1e-12);
  EXPECT_NEAR(ball.y(), shape.ball_height, 1e-12);
}

TEST_F(FootRoll, LandsAndLeavesAtTheStylesAngles) {
  EXPECT_NEAR(stance_pitch(style, 0.0), style.heel_strike_deg * radians_per_degree, 1e-12);
  EXPECT_NEAR(stance_pitch(style, style.stance_share), -style.toe_off_deg * radians_per_degree,
              1e-12);
}

TEST_F(FootRoll, PitchHasNoKinks) {
  constexpr double h = 1e-4;
  for (double phase = h; phase < style.stance_share - 2 * h; phase += h) {
    const double before = stance_pitch(style, phase) - stance_pitch(style, phase - h);
    const double after = stance_pitch(style, phase + h) - stance_pitch(style, phase);
    EXPECT_LT(std::abs(after - before), 5e-5) << phase;
  }
}

TEST_F(FootRoll, ClearancesAreZeroWhenFlat) {
  EXPECT_NEAR(toe_clearance(shape, at(0.25)), 0.0, 1e-12);
  EXPECT_NEAR(heel_clearance(shape, at(0.25)), 0.0, 1e-12);
  EXPECT_GT(toe_clearance(shape, at(0.0)), 0.03);
  EXPECT_GT(heel_clearance(shape, at(0.58)), 0.05);
}

}  // namespace
}  // namespace mien::motion
