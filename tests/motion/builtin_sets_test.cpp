#include "motion/builtin_sets.h"

#include <map>
#include <set>

#include <gtest/gtest.h>

#include "motion/affective_walk.h"
#include "motion/distance.h"
#include "motion/error.h"
#include "motion/gait_measures.h"

namespace mien::motion {
namespace {

std::map<std::string, StyleProfile> profiles_by_name(std::string_view set) {
  std::map<std::string, StyleProfile> result;
  const std::vector<NamedStyle> styles = builtin_styles(set);
  const std::vector<StyleProfile> profiles = builtin_profiles(set);
  for (size_t i = 0; i < styles.size(); ++i) result[styles[i].name] = profiles[i];
  return result;
}

/// Angle of a rotation about the x axis of its own frame, degrees.
double about_x_deg(const Quat& rotation) {
  return log(twist_about(rotation, Vec3::UnitX())).x() / radians_per_degree;
}

TEST(BuiltinSets, TenWalksHaveTheirNames) {
  const ExampleSet set = builtin_examples("walks-10");
  EXPECT_EQ(set.name, "walks-10");
  EXPECT_TRUE(set.simulated);
  ASSERT_EQ(set.examples.size(), 10U);
  std::set<std::string> names;
  for (const Example& example : set.examples) names.insert(example.name);
  EXPECT_EQ(names.size(), 10U);
  for (const char* name : {"normal", "proud", "happy", "sad", "angry"}) {
    EXPECT_TRUE(names.contains(name)) << name;
  }
}

TEST(BuiltinSets, CircumplexWalksAreNineEmotionsAtThreePaces) {
  const ExampleSet set = builtin_examples("walks-27");
  ASSERT_EQ(set.examples.size(), 27U);
  EXPECT_EQ(circumplex_emotions().size(), 9U);
  const auto speed = [](const Example& example) {
    return example.clip.cycle_displacement.z() / example.clip.duration_seconds();
  };
  for (size_t i = 0; i < set.examples.size(); i += 3) {
    EXPECT_TRUE(set.examples[i].name.ends_with("-fast")) << set.examples[i].name;
    EXPECT_TRUE(set.examples[i + 1].name.ends_with("-normal")) << set.examples[i + 1].name;
    EXPECT_TRUE(set.examples[i + 2].name.ends_with("-slow")) << set.examples[i + 2].name;
    EXPECT_GT(speed(set.examples[i]), 1.15 * speed(set.examples[i + 1]));
    EXPECT_LT(speed(set.examples[i + 2]), 0.85 * speed(set.examples[i + 1]));
  }
}

TEST(BuiltinSets, UnknownNameIsRefusedWithTheKnownOnes) {
  try {
    builtin_examples("walks-11");
    FAIL() << "walks-11 was accepted";
  } catch (const Error& error) {
    const std::string what = error.what();
    EXPECT_NE(what.find("\"walks-11\""), std::string::npos) << what;
    EXPECT_NE(what.find("walks-10, walks-27"), std::string::npos) << what;
  }
}

TEST(BuiltinSets, AtAnyRateTheSameWalks) {
  const ExampleSet slow = builtin_examples("walks-10", 30.0);
  const ExampleSet fast = builtin_examples("walks-10", 120.0);
  for (size_t i = 0; i < slow.examples.size(); ++i) {
    EXPECT_LT(distance(slow.examples[i], fast.examples[i]).mean, 0.005) << slow.examples[i].name;
  }
}

TEST(BuiltinSets, NoTwoWalksLookTheSame) {
  const ExampleSet set = builtin_examples("walks-10");
  for (size_t i = 0; i < set.examples.size(); ++i) {
    for (size_t k = i + 1; k < set.examples.size(); ++k) {
      EXPECT_GT(distance(set.examples[i], set.examples[k]).mean, 0.015)
          << set.examples[i].name << " and " << set.examples[k].name;
    }
  }
}

TEST(BuiltinSets, EveryWalkIsWithinHumanRanges) {
  for (const std::string_view name : builtin_set_names()) {
    for (const Example& example : builtin_examples(name, 100.0).examples) {
      const Clip& clip = example.clip;
      const double speed = clip.cycle_displacement.z() / clip.duration_seconds();
      EXPECT_GT(speed, 0.4) << example.name;
      EXPECT_LT(speed, 2.3) << example.name;
      for (const bool left : {true, false}) {
        EXPECT_GT(test::stance_share(clip, left), 0.54) << example.name;
        EXPECT_LT(test::stance_share(clip, left), 0.72) << example.name;
      }
      std::vector<double> heights;
      for (const Pose& pose : clip.poses) {
        heights.push_back(test::centre_of_mass(clip.body, pose).y());
      }
      EXPECT_GT(test::range_of(heights), 0.005) << example.name;
      EXPECT_LT(test::range_of(heights), 0.09) << example.name;
    }
  }
}

TEST(BuiltinSets, NoFootSkatesOrSinksIn) {
  for (const std::string_view name : builtin_set_names()) {
    for (const Example& example : builtin_examples(name, 60.0).examples) {
      EXPECT_LT(test::planted_travel(example.clip, true), 1e-3) << example.name;
      EXPECT_LT(test::planted_travel(example.clip, false), 1e-3) << example.name;
      EXPECT_GT(test::lowest_point(example.clip), -1e-3) << example.name;
    }
  }
}

TEST(BuiltinSets, JointsStayWithinTheirLimits) {
  for (const std::string_view name : builtin_set_names()) {
    for (const Example& example : builtin_examples(name, 60.0).examples) {
      for (const Pose& pose : example.clip.poses) {
        const std::vector<Vec3> joints = world_positions(example.clip.body, pose);
        EXPECT_GE(about_x_deg(pose.rotations[LeftKnee]), 0.0) << example.name;
        EXPECT_LE(about_x_deg(pose.rotations[LeftKnee]), 145.0) << example.name;
        const double hip = -about_x_deg(pose.rotations[LeftHip]);
        EXPECT_GE(hip, -30.0) << example.name;
        EXPECT_LE(hip, 60.0) << example.name;
        const double ankle = -about_x_deg(pose.rotations[LeftAnkle]);
        EXPECT_GE(ankle, -50.0) << example.name;
        EXPECT_LE(ankle, 30.0) << example.name;
        const double elbow = test::bend_deg(joints, LeftShoulder, LeftElbow, LeftWrist);
        EXPECT_LE(elbow, 130.0) << example.name;
        EXPECT_LE(angle_between(Quat::Identity(), pose.rotations[LeftWrist]),
                  60.0 * radians_per_degree)
            << example.name;
        EXPECT_LE(angle_between(Quat::Identity(), pose.rotations[Neck]), 45.0 * radians_per_degree)
            << example.name;
      }
    }
  }
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

TEST(AffectiveWalk, NeutralIsAnOrdinaryWalkAndPacesComposeToNothing) {
  const WalkStyle style = affective_walk(0.3, -0.4);
  const WalkStyle back = at_pace(at_pace(style, 1.25), 0.8);
  EXPECT_NEAR(back.speed_m_s, style.speed_m_s, 1e-12);
  EXPECT_NEAR(back.cadence_steps_min, style.cadence_steps_min, 1e-12);
  EXPECT_NEAR(back.bounce_m, style.bounce_m, 1e-12);
  EXPECT_NEAR(back.arm_swing_deg, style.arm_swing_deg, 1e-9);
  const WalkStyle neutral = affective_walk(0.0, 0.0);
  EXPECT_DOUBLE_EQ(neutral.head_pitch_deg, WalkStyle{}.head_pitch_deg);
  EXPECT_DOUBLE_EQ(neutral.sharpness, 0.0);
}

}  // namespace
}  // namespace mien::motion
