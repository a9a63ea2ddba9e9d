#include "motion/procedural/affective_walk.h"

#include <cmath>

#include <gtest/gtest.h>

namespace mien::motion {
namespace {

TEST(AffectiveWalk, PacesComposeToNothing) {
  const WalkStyle style = affective_walk(0.3, -0.4);
  const WalkStyle back = at_pace(at_pace(style, 1.25), 0.8);
  EXPECT_NEAR(back.speed_m_s, style.speed_m_s, 1e-12);
  EXPECT_NEAR(back.cadence_steps_min, style.cadence_steps_min, 1e-12);
  EXPECT_NEAR(back.stance_share, style.stance_share, 1e-12);
  EXPECT_NEAR(back.bounce_m, style.bounce_m, 1e-12);
  EXPECT_NEAR(back.arm_swing_deg, style.arm_swing_deg, 1e-9);
}

TEST(AffectiveWalk, NeutralHoldsItselfLikeAnOrdinaryWalk) {
  const WalkStyle neutral = affective_walk(0.0, 0.0);
  const WalkStyle ordinary;
  EXPECT_DOUBLE_EQ(neutral.head_pitch_deg, ordinary.head_pitch_deg);
  EXPECT_DOUBLE_EQ(neutral.chest_flexion_deg, ordinary.chest_flexion_deg);
  EXPECT_DOUBLE_EQ(neutral.elbow_flexion_deg,
                   ordinary_walk(neutral.speed_m_s, neutral.cadence_steps_min).elbow_flexion_deg);
  EXPECT_DOUBLE_EQ(neutral.sharpness, 0.0);
  EXPECT_NEAR(neutral.speed_m_s, ordinary.speed_m_s, 0.1);
}

TEST(AffectiveWalk, EmotionsLieOnTheUnitCircleInOrder) {
  double before = -1.0;
  for (const Emotion& emotion : circumplex_emotions()) {
    EXPECT_NEAR(std::hypot(emotion.valence, emotion.arousal), 1.0, 1e-12) << emotion.name;
    double angle = std::atan2(emotion.arousal, emotion.valence);
    if (angle < 0.0) angle += 2.0 * 3.14159265358979;
    EXPECT_GT(angle, before) << emotion.name;
    before = angle;
  }
}

TEST(AffectiveWalk, ArousalQuickensAndValenceLifts) {
  EXPECT_GT(affective_walk(0.0, 1.0).speed_m_s, affective_walk(0.0, -1.0).speed_m_s + 0.3);
  EXPECT_GT(affective_walk(0.0, 1.0).elbow_flexion_deg,
            affective_walk(0.0, -1.0).elbow_flexion_deg);
  EXPECT_LT(affective_walk(1.0, 0.0).head_pitch_deg,
            affective_walk(-1.0, 0.0).head_pitch_deg - 10.0);
  EXPECT_GT(affective_walk(1.0, 0.0).arm_swing_deg, affective_walk(-1.0, 0.0).arm_swing_deg);
  EXPECT_GT(affective_walk(-0.7, 0.7).shoulder_elevation_deg,
            affective_walk(0.7, 0.7).shoulder_elevation_deg + 3.0);
}

}  // namespace
}  // namespace mien::motion
