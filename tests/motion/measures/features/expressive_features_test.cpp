#include "motion/measures/features/expressive_features.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "motion/error.h"
#include "motion/math/rotation.h"
#include "motion/procedural/walker.h"
#include "motion/skeleton/mirror.h"

namespace mien::motion {
namespace {

Clip walk_of(const WalkStyle& style, double fps = 30.0, double height = 1.75) {
  return repeated(walk(style, fps, standard_body(height)).clip, 5);
}

double value(const std::vector<double>& values, const std::string& id) {
  const auto list = expressive_features();
  const auto found =
      std::find_if(list.begin(), list.end(), [&](const auto& feature) { return feature.id == id; });
  EXPECT_NE(found, list.end()) << id;
  return values[static_cast<std::size_t>(found - list.begin())];
}

void expect_equal(const std::vector<double>& a, const std::vector<double>& b, double within) {
  ASSERT_EQ(a.size(), expressive_features().size());
  ASSERT_EQ(b.size(), a.size());
  for (std::size_t k = 0; k < a.size(); ++k)
    EXPECT_NEAR(a[k], b[k], within) << expressive_features()[k].id;
}

TEST(ExpressiveFeatures, HaveNamesOfTheirOwnInThreeFamilies) {
  std::set<std::string> ids;
  std::set<FeatureFamily> families;
  for (const ExpressiveFeature& feature : expressive_features()) {
    ids.insert(feature.id);
    families.insert(feature.family);
  }
  EXPECT_EQ(ids.size(), expressive_features().size());
  EXPECT_EQ(families.size(), 3u);
}

TEST(ExpressiveFeatures, DoNotDependOnPlaceHeadingOrSide) {
  const Clip clip = walk_of({.trunk_rotation_deg = 9.0, .arm_swing_deg = 40.0});
  const std::vector<double> usual = measure_expression(clip);
  Clip turned = clip;
  const Quat turn(Eigen::AngleAxisd(2.1, Vec3::UnitY()));
  for (Pose& pose : turned.poses) {
    pose.root_position = turn * pose.root_position + Vec3(4.0, 0.0, -7.0);
    pose.rotations[Pelvis] = turn * pose.rotations[Pelvis];
  }
  expect_equal(measure_expression(turned), usual, 1e-9);
  expect_equal(measure_expression(mirrored(clip)), usual, 1e-9);
}

TEST(ExpressiveFeatures, OfALoopAreThoseOfItsRepetitions) {
  const Clip loop = walk({}, 30.0, standard_body()).clip;
  const int cycles = static_cast<int>(std::ceil(4.0 / loop.duration_seconds()));
  expect_equal(measure_expression(loop), measure_expression(repeated(loop, cycles)), 1e-9);
}

TEST(ExpressiveFeatures, FollowWhatTheyAreNamedAfter) {
  const std::vector<double> usual = measure_expression(walk_of({}));
  const auto rises = [&](const WalkStyle& style, const std::string& id, double by) {
    EXPECT_GT(value(measure_expression(walk_of(style)), id), value(usual, id) + by) << id;
  };
  rises({.neck_flexion_deg = 30.0}, "mean-head-forward", 0.2);
  rises({.elbow_flexion_deg = 80.0}, "mean-elbow-bend", 0.5);
  rises({.trunk_rotation_deg = 12.0}, "deviation-shoulder-turn", 0.01);
  rises({.arm_swing_deg = 60.0}, "velocity-hand-forward", 0.2);
}

TEST(ExpressiveFeatures, OfHandsAreThoseOfTheirTips) {
  const Clip clip = walk_of({});
  Clip waving = clip;  // by the wrists alone
  for (size_t f = 0; f < waving.poses.size(); ++f) {
    const double turn = 0.5 * std::sin(2.0 * pi * 2.0 * static_cast<double>(f) / 30.0);
    for (const BodyJoint wrist : {LeftWrist, RightWrist})
      waving.poses[f].rotations[wrist] *= exp(Vec3(0.0, turn, 0.0));
  }
  const std::vector<double> usual = measure_expression(clip), waved = measure_expression(waving);
  EXPECT_GT(value(waved, "velocity-hand-forward"), value(usual, "velocity-hand-forward") + 0.05);
  EXPECT_GT(value(waved, "acceleration-hand"), value(usual, "acceleration-hand") + 0.2);
  EXPECT_EQ(value(waved, "mean-elbow-bend"), value(usual, "mean-elbow-bend"));
}

TEST(ExpressiveFeatures, OfAFasterPlaybackRaiseSpeedsAndFrequenciesOnly) {
  const Clip slow = walk_of({}, 60.0);
  Clip fast = slow;
  fast.frames_per_second = 75.0;
  const std::vector<double> a = measure_expression(slow);
  const std::vector<double> b = measure_expression(fast);
  EXPECT_NEAR(value(b, "speed") / value(a, "speed"), 1.25, 0.01);
  EXPECT_NEAR(value(b, "stride-frequency") / value(a, "stride-frequency"), 1.25, 0.06);
  EXPECT_NEAR(value(b, "velocity-hand-forward") - value(a, "velocity-hand-forward"), std::log(1.25),
              0.05);
  EXPECT_NEAR(value(b, "mean-elbow-bend"), value(a, "mean-elbow-bend"), 0.02);
}

TEST(ExpressiveFeatures, OfABodyAtRestAreFinite) {
  Clip still = walk_of({});
  for (Pose& pose : still.poses) pose = still.poses.front();
  const std::vector<double> values = measure_expression(still);
  for (std::size_t k = 0; k < values.size(); ++k)
    EXPECT_TRUE(std::isfinite(values[k])) << expressive_features()[k].id;
  EXPECT_NEAR(value(values, "speed"), 0.0, 1e-12);
}

TEST(ExpressiveFeatures, NeedAThirdOfASecondOfAHumanBody) {
  EXPECT_THROW(measure_expression(cut(walk_of({}), 0, 5)), Error);
  Clip stranger = walk_of({});
  stranger.body.joints.resize(5);
  for (Pose& pose : stranger.poses) pose.rotations.resize(5);
  EXPECT_THROW(measure_expression(stranger), Error);
}

}  // namespace
}  // namespace mien::motion
