#include "motion/style_profile.h"

#include <map>

#include <gtest/gtest.h>

#include "motion/affective_walk.h"
#include "motion/builtin_sets.h"

namespace mien::motion {
namespace {

std::map<std::string, StyleProfile> profiles_by_name(std::string_view set) {
  std::map<std::string, StyleProfile> result;
  const std::vector<NamedStyle> styles = builtin_styles(set);
  const std::vector<StyleProfile> profiles = builtin_profiles(set);
  for (size_t i = 0; i < styles.size(); ++i) result[styles[i].name] = profiles[i];
  return result;
}

TEST(StyleProfile, OrdinaryWalkIsInTheMiddle) {
  for (const double value : profile(WalkStyle{})) EXPECT_DOUBLE_EQ(value, 0.0);
}

TEST(StyleProfile, EmotionsDifferAsPeopleSeeThem) {
  const auto p = profiles_by_name("walks-10");
  EXPECT_GT(p.at("brisk")[Quickness], 0.5);
  EXPECT_LT(p.at("slow")[Quickness], -0.5);
  EXPECT_GT(p.at("happy")[Valence], 0.5);
  EXPECT_LT(p.at("sad")[Valence], -0.5);
  EXPECT_GT(p.at("angry")[Arousal], 0.5);
  EXPECT_LT(p.at("tired")[Arousal], -0.5);
  EXPECT_GT(p.at("proud")[Largeness], 0.4);
  EXPECT_LT(p.at("afraid")[Largeness], -0.5);
  EXPECT_GT(p.at("proud")[Clearness], 0.3);
  EXPECT_LT(p.at("tired")[Clearness], -0.5);
  EXPECT_GT(p.at("angry")[Tension], 0.5);
  EXPECT_GT(p.at("afraid")[Tension], 0.5);
  EXPECT_LT(p.at("relaxed")[Tension], -0.2);
  EXPECT_GT(p.at("happy")[Activeness], 0.5);
  EXPECT_LT(p.at("sad")[Activeness], -0.4);
  EXPECT_LT(p.at("tired")[Stability], -0.5);
}

TEST(StyleProfile, FollowsTheCircumplex) {
  double agreement_valence = 0.0;
  double agreement_arousal = 0.0;
  for (const Emotion& emotion : circumplex_emotions()) {
    const StyleProfile seen = profile(affective_walk(emotion.valence, emotion.arousal));
    agreement_valence += seen[Valence] * emotion.valence;
    agreement_arousal += seen[Arousal] * emotion.arousal;
    if (std::abs(emotion.valence) > 0.4) {
      EXPECT_GT(seen[Valence] * emotion.valence, 0.0) << emotion.name;
    }
    if (std::abs(emotion.arousal) > 0.5) {
      EXPECT_GT(seen[Arousal] * emotion.arousal, 0.0) << emotion.name;
    }
  }
  EXPECT_GT(agreement_valence, 1.5);
  EXPECT_GT(agreement_arousal, 1.5);
}

TEST(StyleProfile, OneCueMovesItsImpressionsTheRightWay) {
  EXPECT_GT(profile(ordinary_walk(1.8, 125.0))[Quickness], 0.5);
  EXPECT_GT(profile(WalkStyle{.arm_swing_deg = 70.0})[Activeness], 0.2);
  EXPECT_GT(profile(WalkStyle{.arm_swing_deg = 70.0})[Largeness], 0.2);
  EXPECT_LT(profile(WalkStyle{.chest_flexion_deg = 20.0})[Valence], -0.2);
  EXPECT_LT(profile(WalkStyle{.head_pitch_deg = 25.0})[Clearness], -0.2);
  EXPECT_GT(profile(WalkStyle{.elbow_flexion_deg = 80.0})[Tension], 0.5);
  EXPECT_LT(profile(WalkStyle{.sway_m = 0.1})[Stability], -0.5);
}

}  // namespace
}  // namespace mien::motion
