#include "motion/measures/features/motion_features.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "motion/examples/example_set.h"
#include "motion/gait/gait.h"
#include "motion/procedural/builtin_sets.h"
#include "motion/procedural/walker.h"
#include "motion/skeleton/mirror.h"
#include "motion/skeleton/straighten.h"

#include "real_data.h"

namespace mien::motion {
namespace {

Example normal_walk() { return builtin_examples("walks-10").examples.front(); }

constexpr double step_m = 0.7;
constexpr double cycle_s = 1.1;

double feature(const FeatureValues& values, std::string_view id) {
  const int index = find_motion_feature(id);
  EXPECT_GE(index, 0) << id;
  return values[static_cast<size_t>(index)];
}

Quat about(const Vec3& axis, double radians) { return Quat(Eigen::AngleAxisd(radians, axis)); }

/// What the synthetic walker does besides stepping.
struct Manner {
  double sway_m = 0.03;         ///< amplitude of the pelvis to the left
  double lean = 0.2;            ///< of the trunk above the pelvis, radians forward
  double left_arm_swing = 0.3;  ///< amplitude, radians
  double left_turnout = 0.1;    ///< of the left foot, radians
};

/// Straight legs that swing at the hips as a cosine so that the ankles are one step apart at the
/// heel strikes; nothing else touches the sagittal plane but what `manner` says.
Example swinging_walker(const Manner& manner, double frames_per_second = 60.0) {
  Example example;
  Clip& clip = example.clip;
  clip.name = example.name = "swinging";
  clip.body = standard_body();
  clip.frames_per_second = frames_per_second;
  clip.loops = true;
  clip.cycle_displacement = Vec3(0, 0, 2 * step_m);
  const double amplitude = std::asin(0.5 * step_m / 0.85);
  const int frames = static_cast<int>(std::lround(cycle_s * frames_per_second));
  for (int f = 0; f < frames; ++f) {
    const double phase = 2 * pi * f / frames;
    const double hip = amplitude * std::cos(phase);
    Pose pose;
    pose.rotations.assign(body_joint_count, Quat::Identity());
    pose.root_position = {manner.sway_m * std::sin(phase), 0.96, 2 * step_m * f / frames};
    pose.rotations[LeftHip] = about(Vec3::UnitX(), -hip);
    pose.rotations[RightHip] = about(Vec3::UnitX(), hip);
    pose.rotations[LeftAnkle] =
        about(Vec3::UnitX(), hip) * about(Vec3::UnitY(), manner.left_turnout);
    pose.rotations[RightAnkle] = about(Vec3::UnitX(), -hip);
    pose.rotations[Spine] = about(Vec3::UnitX(), manner.lean);
    const Quat upright = about(Vec3::UnitX(), -manner.lean);
    const double swing = manner.left_arm_swing * std::cos(phase);
    pose.rotations[LeftShoulder] =
        upright * about(Vec3::UnitX(), swing) * about(Vec3::UnitZ(), -pi / 2);
    pose.rotations[RightShoulder] = upright * about(Vec3::UnitZ(), pi / 2);
    clip.poses.push_back(pose);
  }
  for (const double share : {0.0, 0.1, 0.25, 0.5, 0.6, 0.75, 1.0}) {
    example.keytimes.push_back(share * cycle_s);
  }
  return example;
}

TEST(MotionFeatures, AreTheFiftyOneOfThePublishedTables) {
  std::set<std::string_view> ids, names, japanese;
  std::map<FeatureGroup, int> sizes;
  int reconstructed = 0;
  for (const MotionFeature& f : motion_features()) {
    ids.insert(f.id);
    names.insert(f.name);
    japanese.insert(f.japanese);
    ++sizes[f.group];
    reconstructed += f.reconstructed ? 1 : 0;
    EXPECT_EQ(motion_features()[static_cast<size_t>(find_motion_feature(f.id))].id, f.id);
  }
  EXPECT_EQ(ids.size(), 51u);
  EXPECT_EQ(names.size(), 51u);
  EXPECT_EQ(japanese.size(), 51u);
  EXPECT_EQ(sizes[FeatureGroup::lateral_swing], 6);
  EXPECT_EQ(sizes[FeatureGroup::front_back_swing], 12);
  EXPECT_EQ(sizes[FeatureGroup::upper_body_bend], 16);
  EXPECT_EQ(sizes[FeatureGroup::step_length], 17);
  EXPECT_EQ(reconstructed, 3);
  EXPECT_EQ(find_motion_feature("mu-shin"), -1);
}

TEST(MotionFeatures, OfASinusoidalWalkerAreAnalytic) {
  const Manner manner;
  const FeatureValues v = measure_features(swinging_walker(manner));
  const double root_half = std::sqrt(0.5);
  const double degrees = 1.0 / radians_per_degree;
  const double hip_amplitude = std::asin(0.5 * step_m / 0.85);
  EXPECT_NEAR(feature(v, "duration"), cycle_s, 1e-12);
  EXPECT_NEAR(feature(v, "step-length-fb"), step_m, 1e-12);
  EXPECT_NEAR(feature(v, "step-length-lr"), 0.18, 1e-12);
  EXPECT_NEAR(feature(v, "mu-com-vel-fb"), 2 * step_m / cycle_s, 1e-12);
  EXPECT_NEAR(feature(v, "mu-com-vel-lr"), 0.0, 1e-12);
  for (const char* side : {"left", "right"}) {
    for (const char* segment : {"thigh", "shin"}) {
      const std::string what = std::string(side) + "-" + segment + "-fb";
      EXPECT_NEAR(feature(v, "mu-" + what), 0.0, 1e-9);
      EXPECT_NEAR(feature(v, "sigma-" + what), degrees * hip_amplitude * root_half, 1e-9);
    }
    EXPECT_NEAR(feature(v, std::string("sigma-") + side + "-foot-fb"), 0.0, 1e-9);
  }
  EXPECT_NEAR(feature(v, "mu-right-foot-fb"), 0.0, 1e-9);
  EXPECT_NEAR(feature(v, "mu-left-foot-lr"), degrees * manner.left_turnout, 1e-9);
  EXPECT_NEAR(feature(v, "mu-right-foot-lr"), 0.0, 1e-9);
  EXPECT_NEAR(feature(v, "sigma-com-pos-lr"), manner.sway_m * root_half, 1e-9);
  // Central differences of a sine.
  const double h = cycle_s / 33;
  EXPECT_NEAR(feature(v, "sigma-com-vel-lr"),
              manner.sway_m * std::sin(2 * pi * h / cycle_s) / h * root_half, 1e-9);
  EXPECT_NEAR(feature(v, "sigma-left-upper-arm-fb"), degrees * manner.left_arm_swing * root_half,
              1e-9);
  EXPECT_NEAR(feature(v, "sigma-right-upper-arm-fb"), 0.0, 1e-9);
  EXPECT_NEAR(feature(v, "sigma-left-forearm-fb"), degrees * manner.left_arm_swing * root_half,
              1e-9);
  // The pelvis stays upright; spine to neck is 0.41 m of the 0.52 m from pelvis to neck.
  const double torso = std::atan2(0.41 * std::sin(0.2), 0.11 + 0.41 * std::cos(0.2));
  EXPECT_NEAR(feature(v, "mu-torso-fb"), degrees * torso, 1e-9);
  EXPECT_NEAR(feature(v, "mu-head-fb"), degrees * manner.lean, 1e-9);
  EXPECT_NEAR(feature(v, "sigma-torso-fb"), 0.0, 1e-9);
  EXPECT_NEAR(feature(v, "mu-torso-lr"), 0.0, 1e-9);
}

TEST(MotionFeatures, DoNotDependOnTheFrameRate) {
  const FeatureValues slow = measure_features(swinging_walker({}, 60.0));
  const FeatureValues fast = measure_features(swinging_walker({}, 120.0));
  for (size_t i = 0; i < slow.size(); ++i) {
    EXPECT_NEAR(fast[i], slow[i], 1e-9) << motion_features()[i].id;
  }
}

TEST(MotionFeatures, OfTheParametricWalkAreWhatItsStyleSays) {
  WalkStyle style = ordinary_walk(2 * step_m / cycle_s, 120.0 / cycle_s);
  style.trunk_lean_deg = 12.0;
  const FeatureValues v = measure_features(walk(style, 30.0, standard_body()));
  EXPECT_NEAR(feature(v, "duration"), cycle_s, 1e-9);
  // The rear heel has risen when the other foot strikes.
  EXPECT_LT(feature(v, "step-length-fb"), step_m);
  EXPECT_GT(feature(v, "step-length-fb"), step_m - 0.06);
  EXPECT_NEAR(feature(v, "mu-com-vel-fb"), 2 * step_m / cycle_s, 1e-9);
  const FeatureValues upright = measure_features(
      walk(ordinary_walk(2 * step_m / cycle_s, 120.0 / cycle_s), 30.0, standard_body()));
  EXPECT_GT(feature(v, "mu-torso-fb"), feature(upright, "mu-torso-fb") + 8.0);
}

/// The feature of the other side, and its sign in a mirror.
std::pair<std::string, double> in_the_mirror(std::string id) {
  for (const auto& [here, there] : {std::pair{"-left-", "-right-"}, {"-right-", "-left-"}}) {
    const size_t at = id.find(here);
    if (at == std::string::npos) continue;
    return {id.replace(at, std::string(here).size(), there), 1.0};
  }
  const bool turns = id == "mu-torso-lr" || id == "mu-head-lr" || id == "mu-com-vel-lr";
  return {id, turns ? -1.0 : 1.0};
}

TEST(MotionFeatures, OfAMirroredWalkChangeSides) {
  Example example = builtin_examples("walks-10").examples[5];
  for (Pose& pose : example.clip.poses) {  // no walk is symmetric
    pose.rotations[Chest] = pose.rotations[Chest] * about(Vec3(1, 2, 3).normalized(), 0.15);
    pose.rotations[LeftElbow] = pose.rotations[LeftElbow] * about(Vec3::UnitY(), -0.4);
    pose.rotations[RightAnkle] = pose.rotations[RightAnkle] * about(Vec3::UnitY(), 0.2);
  }
  Example image = example;
  image.clip = mirrored(example.clip);
  const FeatureValues original = measure_features(example);
  const FeatureValues seen = measure_features(image);
  for (const MotionFeature& f : motion_features()) {
    const auto [partner, sign] = in_the_mirror(std::string(f.id));
    EXPECT_NEAR(feature(seen, partner), sign * feature(original, f.id), 1e-8) << f.id;
  }
  EXPECT_GT(std::abs(feature(original, "mu-torso-lr")), 1.0);
}

TEST(MotionFeatures, CountSidewaysToTheLeftWhenAskedTo) {
  const Example example = builtin_examples("walks-10").examples[0];
  const FeatureValues outward = measure_features(example);
  const FeatureValues leftward = measure_features(example, {.outward = false});
  EXPECT_NEAR(feature(leftward, "mu-left-foot-lr"), feature(outward, "mu-left-foot-lr"), 1e-12);
  EXPECT_NEAR(feature(leftward, "mu-right-foot-lr"), -feature(outward, "mu-right-foot-lr"), 1e-12);
  EXPECT_GT(feature(outward, "mu-right-foot-lr"), 3.0);
}

TEST(MotionFeatures, ChangeNeitherWithATurnNorWithAShift) {
  const Example example = builtin_examples("walks-10").examples[3];
  Example moved = example;
  const Quat turn = about(Vec3::UnitY(), 2.3);
  for (Pose& pose : moved.clip.poses) {
    pose.root_position = turn * pose.root_position + Vec3(4, 0, -7);
    pose.rotations[Pelvis] = turn * pose.rotations[Pelvis];
  }
  moved.clip.cycle_displacement = turn * example.clip.cycle_displacement;
  const FeatureValues before = measure_features(example);
  const FeatureValues after = measure_features(moved);
  for (size_t i = 0; i < before.size(); ++i) {
    EXPECT_NEAR(after[i], before[i], 1e-9) << motion_features()[i].id;
  }
}

TEST(MotionFeatures, AngleOfAnArmSwungAllRoundHasNoJump) {
  Example example = swinging_walker({});
  Clip& clip = example.clip;
  clip.loops = false;
  for (int f = 0; f < clip.frame_count(); ++f) {  // down, back, up, front: once round
    clip.poses[f].rotations[RightShoulder] =
        about(Vec3::UnitX(), 2 * pi * f / (clip.frame_count() - 1) - 0.2) *
        about(Vec3::UnitZ(), pi / 2);
  }
  const FeatureValues v = measure_features(example);
  // An even sweep of 360° has the standard deviation 360/√12 (n points: times √((n+1)/(n−1))).
  const auto n = std::lround(30.0 * clip.duration_seconds()) + 1;
  EXPECT_NEAR(feature(v, "sigma-right-upper-arm-fb"),
              360.0 / std::sqrt(12.0) * std::sqrt((n + 1.0) / (n - 1.0)), 1e-3);
}

TEST(MotionFeatures, AnglesOfARaisedArmDoNotDependOnWhereTheCycleBegins) {
  // A forearm that swings about straight up: frames are on both sides of 180 degrees.
  Example example = swinging_walker({});
  for (Pose& pose : example.clip.poses)
    pose.rotations[LeftShoulder] = about(Vec3::UnitX(), -pi + 0.1) * pose.rotations[LeftShoulder];
  const FeatureValues values = measure_features(example);
  std::vector<Pose>& poses = example.clip.poses;
  for (const char* id : {"mu-left-forearm-fb", "mu-left-upper-arm-fb"}) {
    EXPECT_GT(feature(values, id), 90.0) << id;
    for (int turns = 0; turns < 6; ++turns) {
      std::rotate(poses.begin(), poses.begin() + poses.size() / 6, poses.end());
      EXPECT_NEAR(feature(measure_features(example), id), feature(values, id), 1e-9) << id;
    }
  }
}

TEST(MotionFeatures, OfAWalkOnATreadmillAreThoseOfTheWalk) {
  const Example walked = normal_walk();
  Example belt = walked;
  belt.clip = in_place(walked.clip);
  const int frames = belt.clip.frame_count();
  for (const double drift_m : {0.0, 0.0005, 0.02}) {
    Example drifting = belt;
    for (int f = 0; f < frames; ++f)
      drifting.clip.poses[f].root_position.x() += drift_m * f / frames;
    drifting.clip.cycle_displacement.x() += drift_m;
    EXPECT_NEAR(feature(measure_features(drifting), "mu-com-vel-fb"),
                feature(measure_features(walked), "mu-com-vel-fb"), 0.06)
        << drift_m;
  }
}

TEST(MotionFeatures, OfWhoWalksBackwardsAreMeasuredFromTheFrontOfTheBody) {
  const Example forwards = normal_walk();
  Example backwards = forwards;
  backwards.keytimes.clear();
  Clip& clip = backwards.clip;
  std::reverse(clip.poses.begin(), clip.poses.end());
  clip.cycle_displacement = -clip.cycle_displacement;
  const FeatureValues there = measure_features(forwards), back = measure_features(backwards);
  for (const MotionFeature& of : motion_features()) {
    const std::string id(of.id);
    if (of.unit != FeatureUnit::degrees) continue;
    EXPECT_NEAR(feature(back, id), feature(there, id), 0.5) << id;
  }
  EXPECT_NEAR(feature(back, "mu-com-vel-fb"), feature(there, "mu-com-vel-fb"), 1e-6);
}

TEST(MotionFeatures, ASteepFootSaysNothingOfItsTurn) {
  Example example = swinging_walker({});
  Example steep = example;
  for (int f = 10; f < 20; ++f) {  // on the tips of the toes, a little beyond the vertical
    steep.clip.poses[f].rotations[LeftAnkle] =
        steep.clip.poses[f].rotations[LeftAnkle] * about(Vec3::UnitX(), 1.6);
  }
  EXPECT_NEAR(feature(measure_features(steep), "mu-left-foot-lr"),
              feature(measure_features(example), "mu-left-foot-lr"), 1e-9);
  EXPECT_LT(feature(measure_features(steep), "mu-left-foot-fb"), -10.0);
}

TEST(MotionFeatures, APerformanceHasNoSteps) {
  Example example = swinging_walker({});
  example.clip.loops = false;
  example.keytimes = {0.0, example.clip.duration_seconds()};
  const FeatureValues v = measure_features(example);
  for (size_t i = 0; i < v.size(); ++i) {
    const std::string_view id = motion_features()[i].id;
    EXPECT_EQ(std::isnan(v[i]), id.starts_with("step-length")) << id;
  }
}

TEST(MotionFeatures, OfRealOrdinaryWalksAreInTheRangesOfHealthyAdults) {
  const auto data = test::real_data();
  if (!data) GTEST_SKIP() << "no real motion data: set MIEN_DATA";
  ExampleFolder folder;
  folder.path = *data / "mocap" / "bandai-namco-1";
  folder.include = "*walk_normal_*.bvh";
  for (const Example& example : load_examples(folder).set.examples) {
    const FeatureValues v = measure_features(example);
    EXPECT_GT(feature(v, "mu-com-vel-fb"), 0.9) << example.name;
    EXPECT_LT(feature(v, "mu-com-vel-fb"), 1.6) << example.name;
    EXPECT_GT(feature(v, "duration"), 0.95) << example.name;
    EXPECT_LT(feature(v, "duration"), 1.25) << example.name;
    EXPECT_GT(feature(v, "step-length-fb"), 0.5) << example.name;
    EXPECT_LT(feature(v, "step-length-fb"), 0.8) << example.name;
    // A sine of 3–5 cm range has a standard deviation of 1.1–1.8 cm.
    EXPECT_GT(feature(v, "sigma-com-pos-v"), 0.006) << example.name;
    EXPECT_LT(feature(v, "sigma-com-pos-v"), 0.022) << example.name;
    EXPECT_LT(std::abs(feature(v, "mu-torso-fb")), 12.0) << example.name;
  }
}

}  // namespace
}  // namespace mien::motion
