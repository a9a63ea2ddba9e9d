#include "motion/procedural/builtin_sets.h"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "motion/error.h"
#include "motion/gait_measures.h"
#include "motion/measures/distance/distance.h"
#include "motion/procedural/affective_walk.h"

namespace mien::motion {
namespace {

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

TEST(BuiltinSets, ActorsKeepTheirPlacesAndGetFurtherWalksBehind) {
  const std::vector<std::string> names = builtin_example_names("actors");
  ASSERT_EQ(names.size(), 34U);
  EXPECT_EQ(names.front(), "woman-walk-neutral");
  EXPECT_EQ(names[27], "man-stand-strong");  // the last of the 28 that there were
  EXPECT_EQ(names.back(), "man-walk-weak");
}

TEST(BuiltinSets, ActorsActExcitedStrongAndWeakWalksApartFromAllOthers) {
  const ExampleSet set = builtin_examples("actors");
  const auto of = [&](const std::string& name) -> const Example& {
    return *std::ranges::find(set.examples, name, &Example::name);
  };
  const auto speed = [](const Example& example) {
    return example.clip.cycle_displacement.z() / example.clip.duration_seconds();
  };
  for (const std::string actor : {"woman", "man"}) {
    const std::string walk = actor + "-walk-";
    EXPECT_GT(speed(of(walk + "excited")), 1.1 * speed(of(walk + "neutral")));
    EXPECT_LT(speed(of(walk + "weak")), 0.6 * speed(of(walk + "neutral")));
    for (const char* own : {"excited", "strong", "weak"}) {
      for (const Example& other : set.examples) {
        if (!other.name.starts_with(walk) || other.name == walk + own) continue;
        EXPECT_GT(distance(of(walk + own), other).mean, 0.02) << own << " " << other.name;
      }
    }
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
      if (!clip.loops) continue;  // knocks and standing
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

}  // namespace
}  // namespace mien::motion
