#include "motion/modify/relative_change.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "motion/error.h"
#include "motion/gait/contact.h"
#include "motion/gait/foot_lock.h"
#include "motion/gait/gait_plants.h"
#include "motion/math/rotation.h"
#include "motion/modify/feet_apart.h"
#include "motion/modify/modification.h"
#include "motion/procedural/builtin_sets.h"
#include "motion/procedural/knock.h"
#include "motion/procedural/walker.h"
#include "motion/skeleton/straighten.h"
#include "motion/synthetic_run.h"

namespace mien::motion {
namespace {

Clip walking() { return walk({}, 100.0, standard_body()).clip; }

Clip standing() {
  Clip clip;
  clip.body = standard_body();
  clip.poses.assign(10, standing_pose(clip.body));
  return clip;
}

Modification relative(const RelativeChange& change) {
  Modification modification;
  modification.relative = change;
  return modification;
}

double spread(const std::vector<double>& values) {
  double mean = 0.0, square = 0.0;
  for (const double value : values) mean += value / static_cast<double>(values.size());
  for (const double value : values)
    square += (value - mean) * (value - mean) / static_cast<double>(values.size());
  return std::sqrt(square);
}

/// How far a joint turns about its mean, radians.
double swing_of(const Clip& clip, BodyJoint joint) {
  std::vector<double> angles;
  for (const Pose& pose : clip.poses) {
    const Vec3 bone = pose.rotations[joint] * rest_direction(joint);
    angles.push_back(std::atan2(bone.z(), -bone.y()));
  }
  return spread(angles);
}

double sway_of(const Clip& clip) {
  std::vector<double> places;
  for (const Pose& pose : straightened(clip).poses) places.push_back(pose.root_position.x());
  return spread(places);
}

TEST(RelativeChange, TakesASharePartWayToTheEndOfTheRange) {
  const Clip clip = standing();  // elbows bent by 12 degrees
  const auto bend = [&](double share) {
    return posture_of({.range = {{PostureUnit::elbow_flexion, share}}}, clip, {}).at(0).degrees;
  };
  EXPECT_NEAR(bend(0.5), 0.5 * (150.0 - 12.0), 1e-9);
  EXPECT_NEAR(bend(-0.5), -0.5 * 12.0, 1e-9);
  EXPECT_EQ(bend(0.0), 0.0);
}

TEST(RelativeChange, ReachesTheEndsOfEveryRangeAndNoMore) {
  const Clip clip = standing();
  for (const PostureUnitName& unit : posture_units()) {
    const std::optional<UnitRange> range = range_of(unit.unit);
    if (!range) continue;
    for (const double share : {1.0, -1.0}) {
      const Clip bent = with_posture(clip, posture_of({.range = {{unit.unit, share}}}, clip, {}));
      const double end = share > 0.0 ? range->most : range->least;
      const double reached = own_angle(bent, unit.unit);
      // Arms that hang 8 degrees from the body are not raised into the midline plane.
      EXPECT_NEAR(reached, end, unit.unit == PostureUnit::shoulder_flexion ? 8.5 : 2.0)
          << unit.name << " " << share;
      EXPECT_LT(reached, range->most + 2.0) << unit.name;
      EXPECT_GT(reached, range->least - 2.0) << unit.name;
    }
  }
}

TEST(RelativeChange, AsksLessOfWhoDoesItAlready) {
  const Clip clip = standing();
  const Clip bowed = with_posture(clip, {{PostureUnit::spine_flexion, 30.0}});
  const RelativeChange stoop{.range = {{PostureUnit::spine_flexion, 0.2}}};
  const double upright = posture_of(stoop, clip, {}).at(0).degrees;
  EXPECT_NEAR(posture_of(stoop, bowed, {}).at(0).degrees, upright - 0.2 * 30.0, 0.1);
}

TEST(RelativeChange, DoesNotPressArmsIntoTheBody) {
  const Clip crossed = with_posture(standing(), {{PostureUnit::shoulder_abduction, -20.0}});
  const RelativeChange narrow{.range = {{PostureUnit::shoulder_abduction, -1.0}}};
  EXPECT_EQ(posture_of(narrow, crossed, {}).at(0).degrees, 0.0);
}

TEST(RelativeChange, MultipliesTheWidthOfSteps) {
  const Clip clip = walking();
  const std::vector<FootPlant> plants = foot_plants(clip);
  const double own = *mean_step_width(clip, plants);
  for (const double factor : {1.3, 1.6}) {
    const Clip wide = modified(clip, relative({.step_width = factor}));
    EXPECT_NEAR(*mean_step_width(wide, plants), factor * own, 0.015) << factor;
    EXPECT_LT(planted_drift(wide, plants), 0.001);
  }
}

TEST(RelativeChange, LeavesTheWidthOfAFoot) {
  const Clip clip = modified(walking(), relative({.step_width = 1.6}));
  const std::vector<FootPlant> plants = foot_plants(clip);
  ASSERT_GT(*mean_step_width(clip, plants), foot_width(clip.body) + 0.02);
  const Clip narrow = modified(clip, relative({.step_width = 0.0}));
  EXPECT_NEAR(*mean_step_width(narrow, plants), foot_width(clip.body), 0.01);
  // Steps that are narrower already stay as they are.
  const Clip narrower = modified(clip, relative({.step_width = 0.0}));
  EXPECT_GE(*mean_step_width(modified(narrower, relative({.step_width = 0.5})), plants),
            *mean_step_width(narrower, plants) - 0.01);
}

TEST(RelativeChange, MultipliesTheSwingOfArmsAboutTheirOwnMean) {
  const Clip clip = walking();
  for (const double factor : {0.0, 0.5, 1.8}) {
    const Clip swung = with_swing(clip, {.arm_swing = factor});
    EXPECT_NEAR(swing_of(swung, LeftShoulder), factor * swing_of(clip, LeftShoulder), 0.01);
    EXPECT_NEAR(own_angle(swung, PostureUnit::elbow_flexion),
                own_angle(clip, PostureUnit::elbow_flexion), 0.5);
    EXPECT_EQ(swing_of(swung, LeftHip), swing_of(clip, LeftHip));
  }
}

TEST(RelativeChange, MultipliesTheSwingOfArmsInACapturedWalk) {
  const Clip take = repeated(walking(), 4);
  ASSERT_FALSE(take.loops);
  const Clip swung = with_swing(take, {.arm_swing = 0.2});
  for (const BodyJoint arm : {LeftShoulder, RightShoulder})
    EXPECT_NEAR(swing_of(swung, arm), 0.2 * swing_of(take, arm), 0.1 * swing_of(take, arm));
}

TEST(RelativeChange, LeavesTheArmsOfAGestureAlone) {
  const Clip clip = knock({}, 30.0, standard_body()).clip;
  const Clip swung = with_swing(clip, {.arm_swing = 0.3});
  for (size_t f = 0; f < clip.poses.size(); ++f) {
    EXPECT_EQ(swung.poses[f].rotations[RightShoulder].coeffs(),
              clip.poses[f].rotations[RightShoulder].coeffs());
  }
}

TEST(RelativeChange, KeepsTheLegsWhenTheTrunkMovesMore) {
  const Clip clip = walking();
  const Clip swung = with_swing(clip, {.trunk_swing = 2.0});
  for (size_t f = 0; f < clip.poses.size(); f += 7) {
    const JointTransforms before = world_transforms(clip.body, clip.poses[f]);
    const JointTransforms after = world_transforms(clip.body, swung.poses[f]);
    EXPECT_LT(angle_between(before.rotations[LeftHip], after.rotations[LeftHip]), 1e-9);
  }
  EXPECT_GT(swing_of(swung, Chest), 1.5 * swing_of(clip, Chest));
}

TEST(RelativeChange, ShortensStepsAndKeepsFeetPlanted) {
  const Clip clip = walking();
  const std::vector<FootPlant> plants = foot_plants(clip);
  const Clip shorter = modified(clip, relative({.step_length = 0.7}));
  const double ratio = shorter.cycle_displacement.norm() / clip.cycle_displacement.norm();
  EXPECT_GT(ratio, 0.6);
  EXPECT_LT(ratio, 0.82);
  EXPECT_TRUE(shorter.loops);
  EXPECT_LT(planted_drift(shorter, plants), 0.001);
}

TEST(RelativeChange, MultipliesTheSwayOverPlantedFeet) {
  const Clip clip = walking();
  const std::vector<FootPlant> plants = foot_plants(clip);
  for (const double factor : {0.5, 2.0}) {
    const Clip swaying = modified(clip, relative({.sway = factor}));
    EXPECT_NEAR(sway_of(swaying) / sway_of(clip), factor, 0.25 * factor) << factor;
    EXPECT_LT(planted_drift(swaying, plants), 0.001);
  }
}

TEST(RelativeChange, OfNoStrengthIsNone) {
  const RelativeChange change{
      .step_width = 0.5, .arm_swing = 2.0, .range = {{PostureUnit::elbow_flexion, 0.4}}};
  EXPECT_FALSE(is_identity(change));
  EXPECT_TRUE(is_identity(scaled(change, 0.0)));
  EXPECT_NEAR(scaled(change, 0.5).step_width, std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(scaled(change, 2.0).arm_swing, 3.0, 1e-12);  // the most there is
  EXPECT_NEAR(scaled(change, 0.5).range.at(0).share, 0.2, 1e-12);
}

TEST(RelativeChange, IsRefusedOutsideItsRanges) {
  EXPECT_THROW(check(RelativeChange{.arm_swing = 3.1}), Error);
  EXPECT_THROW(check(RelativeChange{.step_length = -0.1}), Error);
  EXPECT_THROW(check(RelativeChange{.range = {{PostureUnit::elbow_flexion, 1.1}}}), Error);
  EXPECT_THROW(check(RelativeChange{.range = {{PostureUnit::head_turn, 0.1}}}), Error);
  EXPECT_NO_THROW(check(RelativeChange{.range = {{PostureUnit::elbow_flexion, -1.0}}}));
}

/// Amplitude of what alternates from frame to frame in the turns of a joint, radians.
double tremor(const Clip& clip, BodyJoint joint) {
  double sum = 0.0;
  for (size_t f = 1; f + 1 < clip.poses.size(); ++f) {
    const Quat& here = clip.poses[f].rotations[joint];
    const Vec3 before = log(here.conjugate() * clip.poses[f - 1].rotations[joint]);
    const Vec3 after = log(here.conjugate() * clip.poses[f + 1].rotations[joint]);
    sum += (before + after).norm() / 4.0;
  }
  return sum / static_cast<double>(clip.poses.size() - 2);
}

TEST(RelativeChange, SwingsLegsInATakeAsInItsLoopWhereverTheTakeStarts) {
  const Clip loop = walking();
  const Clip longer = with_swing(loop, {.step_length = 1.3});
  const Clip strides = repeated(loop, 6);
  const int cycle = loop.frame_count();
  for (const int start : {0, cycle / 8, cycle / 4, cycle / 2, 3 * cycle / 4}) {
    Clip take = strides;
    take.poses.erase(take.poses.begin(), take.poses.begin() + start);
    const Clip changed = with_swing(take, {.step_length = 1.3});
    double farthest = 0.0;
    for (int f = 0; f < cycle; ++f) {
      const Pose& expected = longer.poses[static_cast<size_t>((start + f) % cycle)];
      const Pose& pose = changed.poses[static_cast<size_t>(f)];
      for (const BodyJoint hip : {LeftHip, RightHip})
        farthest = std::max(farthest, angle_between(pose.rotations[hip], expected.rotations[hip]));
    }
    EXPECT_LT(farthest / radians_per_degree, 4.0) << start;
  }
}

TEST(RelativeChange, MultipliesSwingButNotTheNoiseOfACapture) {
  Clip noisy = walking();
  for (size_t f = 0; f < noisy.poses.size(); ++f) {
    const double noise = (f % 2 == 0 ? 0.3 : -0.3) * radians_per_degree;
    Quat& chest = noisy.poses[f].rotations[Chest];
    chest = (chest * exp(Vec3(noise, 0.0, noise))).normalized();
  }
  const Clip more = with_swing(noisy, {.trunk_swing = 2.0});
  EXPECT_NEAR(tremor(more, Chest) / tremor(noisy, Chest), 1.0, 0.1);
}

TEST(RelativeChange, MovesRunningFeetWithTheFloor) {
  test::SyntheticRun gait;
  gait.stance = 0.2;
  const Clip run = test::steady_run(gait, 2.0 * gait.stride, 2.5);
  for (const double factor : {0.8, 1.2}) {
    const Clip changed = modified(run, relative({.step_length = factor}));
    const std::vector<FootPlant> plants = gait_plants(run);
    ASSERT_FALSE(plants.empty());
    EXPECT_LT(planted_drift(changed, plants), 0.002) << factor;
  }
}

TEST(RelativeChange, MultipliesTheMovementOfTheTrunkLessInAGesture) {
  Clip clip = knock({}, 60.0, standard_body()).clip;
  for (size_t f = 0; f < clip.poses.size(); ++f) {
    const double share = static_cast<double>(f) / static_cast<double>(clip.poses.size());
    clip.poses[f].rotations[Chest] =
        exp(Vec3(0.0, 0.0, 8.0 * radians_per_degree * std::sin(4.0 * pi * share)));
  }
  const auto turned = [&](const Clip& of) {
    double most = 0.0;
    for (const Pose& pose : of.poses)
      most = std::max(most, angle_between(pose.rotations[Chest], of.poses[0].rotations[Chest]));
    return most;
  };
  const double factor = turned(with_swing(clip, {.trunk_swing = 2.0})) / turned(clip);
  EXPECT_GT(factor, 1.05);
  EXPECT_LT(factor, 1.4);
}

}  // namespace
}  // namespace mien::motion
