#include "motion/procedural/walker.h"

#include <random>

#include <gtest/gtest.h>

#include "motion/error.h"
#include "motion/gait_measures.h"

namespace mien::motion {
namespace {

using test::harmonic_amplitude;
using test::knee_flexion_deg;
using test::range_of;

Example normal_walk(double frames_per_second = 100.0) {
  return walk(WalkStyle{}, frames_per_second, standard_body());
}

std::vector<double> centre_of_mass_heights(const Clip& clip) {
  std::vector<double> heights;
  for (const Pose& pose : clip.poses) {
    heights.push_back(test::centre_of_mass(clip.body, pose).y());
  }
  return heights;
}

size_t frame_at(const Clip& clip, double share) {
  return static_cast<size_t>(std::lround(share * clip.frame_count())) %
         static_cast<size_t>(clip.frame_count());
}

/// A style drawn from the wide range of human walks.
WalkStyle random_style(std::mt19937& random) {
  const auto between = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / 4294967295.0;
  };
  const double step = between(0.35, 0.85);
  const double cadence = between(75.0, 135.0);
  WalkStyle style = ordinary_walk(step * cadence / 60.0, cadence);
  style.step_width_m = between(0.04, 0.2);
  style.foot_progression_deg = between(-5.0, 20.0);
  style.heel_strike_deg = between(0.0, 28.0);
  style.stance_knee_deg = between(3.0, 25.0);
  style.swing_knee_deg = between(50.0, 80.0);
  style.foot_clearance_m = between(0.005, 0.04);
  style.bounce_m *= between(0.5, 1.5);
  style.sway_m = between(0.0, 0.08);
  style.impact_m = between(0.0, 0.015);
  style.pelvis_obliquity_deg = between(0.0, 7.0);
  style.trunk_lean_deg = between(-6.0, 15.0);
  style.sharpness = between(-1.0, 1.0);
  return style;
}

TEST(Walker, NormalWalkIsInTheRangesOfHealthyAdults) {
  const Example example = normal_walk();
  const Clip& clip = example.clip;
  const double cycle = clip.duration_seconds();
  const double stride = clip.cycle_displacement.z();
  EXPECT_GE(cycle, 1.0);
  EXPECT_LE(cycle, 1.2);
  EXPECT_GE(stride, 1.2);
  EXPECT_LE(stride, 1.5);
  EXPECT_GE(stride / cycle, 1.2);
  EXPECT_LE(stride / cycle, 1.5);
  EXPECT_GE(120.0 / cycle, 100.0);
  EXPECT_LE(120.0 / cycle, 120.0);
  for (const bool left : {true, false}) {
    EXPECT_GE(test::stance_share(clip, left), 0.58);
    EXPECT_LE(test::stance_share(clip, left), 0.62);
    const std::vector<double> knee = knee_flexion_deg(clip, left);
    const double peak = *std::max_element(knee.begin(), knee.end());
    EXPECT_GE(peak, 55.0);
    EXPECT_LE(peak, 65.0);
  }
  const double double_support = test::stance_share(clip, true) - 0.5;
  EXPECT_GE(double_support, 0.10);
  EXPECT_LE(double_support, 0.12);
}

TEST(Walker, NormalStepsAreAsWideAsHealthyAdultsTakeThem) {
  const Clip clip = normal_walk().clip;
  const std::vector<Vec3> left = world_positions(clip.body, clip.poses[frame_at(clip, 0.25)]);
  const std::vector<Vec3> right = world_positions(clip.body, clip.poses[frame_at(clip, 0.75)]);
  const double width = left[LeftAnkle].x() - right[RightAnkle].x();
  EXPECT_GE(width, 0.05);
  EXPECT_LE(width, 0.13);
}

TEST(Walker, CentreOfMassRisesTwiceAStride) {
  const std::vector<double> heights = centre_of_mass_heights(normal_walk().clip);
  EXPECT_GE(range_of(heights), 0.03);
  EXPECT_LE(range_of(heights), 0.05);
  EXPECT_GT(harmonic_amplitude(heights, 2), 10.0 * harmonic_amplitude(heights, 1));
  EXPECT_GT(harmonic_amplitude(heights, 2), 5.0 * harmonic_amplitude(heights, 4));
}

TEST(Walker, CentreOfMassShiftsOverTheStandingLeg) {
  const Clip clip = normal_walk().clip;
  const auto lateral = [&](double share) {
    return test::centre_of_mass(clip.body, clip.poses[frame_at(clip, share)]).x();
  };
  EXPECT_GT(lateral(0.3), 0.01);
  EXPECT_LT(lateral(0.8), -0.01);
}

TEST(Walker, NormalKneeBendsInLoadingAndIsNearlyStraightInMidStance) {
  // Textbook shape of level walking (Winter 1991; Perry & Burnfield 2010), within a few degrees.
  const Clip clip = normal_walk().clip;
  const std::vector<double> knee = knee_flexion_deg(clip, true);
  const auto at = [&](double share) { return knee[frame_at(clip, share)]; };
  EXPECT_NEAR(at(0.0), 5.0, 4.0);
  EXPECT_NEAR(at(0.14), 18.0, 5.0);
  EXPECT_NEAR(at(0.40), 6.0, 4.0);
  EXPECT_NEAR(at(0.60), 38.0, 8.0);
  EXPECT_NEAR(at(0.73), 62.0, 5.0);
  EXPECT_NEAR(at(0.97), 4.0, 5.0);
}

TEST(Walker, NormalThighSwingsFromFlexionAtHeelStrikeToExtensionBehind) {
  const Clip clip = normal_walk().clip;
  const auto thigh = [&](double share) {
    const std::vector<Vec3> joints = world_positions(clip.body, clip.poses[frame_at(clip, share)]);
    const Vec3 bone = joints[LeftKnee] - joints[LeftHip];
    return std::atan2(bone.z(), -bone.y()) / radians_per_degree;
  };
  EXPECT_NEAR(thigh(0.0), 26.0, 6.0);
  EXPECT_NEAR(thigh(0.52), -18.0, 6.0);
}

TEST(Walker, ArmsSwingAgainstTheLegsAndForearmsFollowLate) {
  const Clip clip = normal_walk().clip;
  std::vector<double> arm;
  std::vector<double> elbow;
  for (const Pose& pose : clip.poses) {
    const std::vector<Vec3> joints = world_positions(clip.body, pose);
    arm.push_back(joints[LeftElbow].z() - joints[LeftShoulder].z());
    elbow.push_back(test::bend_deg(joints, LeftShoulder, LeftElbow, LeftWrist));
  }
  const auto forward = std::max_element(arm.begin(), arm.end()) - arm.begin();
  const auto flexed = std::max_element(elbow.begin(), elbow.end()) - elbow.begin();
  EXPECT_NEAR(static_cast<double>(forward) / clip.frame_count(), 0.54, 0.05);
  EXPECT_GT(flexed, forward);
  EXPECT_LT(flexed, forward + 0.15 * clip.frame_count());
}

TEST(Walker, HeadTurnsLessThanTheShoulders) {
  const Clip clip = normal_walk().clip;
  std::vector<double> head;
  std::vector<double> shoulders;
  for (const Pose& pose : clip.poses) {
    const JointTransforms world = world_transforms(clip.body, pose);
    const Vec3 face = world.rotations[Head] * Vec3::UnitZ();
    const Vec3 line = world.positions[LeftShoulder] - world.positions[RightShoulder];
    head.push_back(std::atan2(face.x(), face.z()));
    shoulders.push_back(std::atan2(-line.z(), line.x()));
  }
  EXPECT_LT(range_of(head), 0.25 * range_of(shoulders));
}

TEST(Walker, SecondHalfMirrorsTheFirst) {
  const Clip clip = walk(WalkStyle{.cadence_steps_min = 120.0}, 100.0, standard_body()).clip;
  ASSERT_EQ(clip.frame_count() % 2, 0);
  const auto half = static_cast<size_t>(clip.frame_count() / 2);
  for (size_t i = 0; i < half; ++i) {
    const std::vector<Vec3> a = world_positions(clip.body, clip.poses[i]);
    const std::vector<Vec3> b = world_positions(clip.body, clip.poses[i + half]);
    for (size_t j = 0; j < a.size(); ++j) {
      const Vec3& other = b[static_cast<size_t>(mirrored(BodyJoint(j)))];
      const Vec3 expected(-other.x(), other.y(), other.z() - 0.5 * clip.cycle_displacement.z());
      EXPECT_LT((a[j] - expected).norm(), 1e-9) << name_of(BodyJoint(j)) << " in frame " << i;
    }
  }
}

TEST(Walker, KeytimesMarkHeelStrikesToeOffsAndPassingAnkles) {
  const Example example = normal_walk(200.0);
  ASSERT_EQ(example.keytimes.size(), 7U);
  EXPECT_EQ(example.keytimes.front(), 0.0);
  EXPECT_DOUBLE_EQ(example.keytimes.back(), example.clip.duration_seconds());
  EXPECT_TRUE(std::is_sorted(example.keytimes.begin(), example.keytimes.end()));
  const auto ahead = [&](double seconds) {
    const std::vector<Vec3> joints =
        world_positions(example.clip.body, pose_at(example.clip, seconds));
    return joints[RightAnkle].z() - joints[LeftAnkle].z();
  };
  EXPECT_NEAR(ahead(example.keytimes[2]), 0.0, 2e-3);
  EXPECT_NEAR(ahead(example.keytimes[5]), 0.0, 2e-3);
  // The left heel comes down at the first keytime and is up shortly before it.
  const auto frames = example.clip.poses.size();
  EXPECT_TRUE(test::foot_contact(example.clip, 0, true).heel);
  EXPECT_FALSE(test::foot_contact(example.clip, frames - 2, true).heel);
  const auto toe_off = static_cast<size_t>(example.keytimes[4] * 200.0);
  EXPECT_TRUE(test::foot_contact(example.clip, toe_off - 1, true).ball);
  EXPECT_FALSE(test::foot_contact(example.clip, toe_off + 4, true).ball);
}

TEST(Walker, CycleLastsTheNearestWholeNumberOfFramesAndKeepsTheStep) {
  const WalkStyle style;
  for (const double fps : {24.0, 30.0, 60.0, 120.0}) {
    const Clip clip = walk(style, fps, standard_body()).clip;
    EXPECT_NEAR(clip.duration_seconds(), 120.0 / style.cadence_steps_min, 0.5 / fps + 1e-9);
    EXPECT_NEAR(clip.cycle_displacement.z(), 2.0 * step_length_m(style), 1e-9);
  }
}

TEST(Walker, SeamIsNoRougherThanTheRestOfTheCycle) {
  const Clip clip = walk(WalkStyle{.cadence_steps_min = 120.0}, 100.0, standard_body()).clip;
  const Clip twice = repeated(clip, 2);
  const auto paths = joint_paths(twice);
  const auto n = static_cast<size_t>(clip.frame_count());
  for (int j = 0; j < body_joint_count; ++j) {
    const auto acceleration = [&](size_t i, int joint) {
      const auto index = static_cast<size_t>(joint);
      return (paths[i + 1][index] - 2.0 * paths[i][index] + paths[i - 1][index]).norm();
    };
    double roughest = 0.0;
    for (size_t i = 2; i < n - 2; ++i) {
      roughest = std::max({roughest, acceleration(i, j), acceleration(i, mirrored(BodyJoint(j)))});
    }
    for (size_t i = n - 1; i <= n + 1; ++i) {
      EXPECT_LE(acceleration(i, j), 1.05 * roughest) << name_of(BodyJoint(j)) << " frame " << i;
    }
  }
}

TEST(Walker, EveryHumanStyleKeepsItsFeetOnTheFloorWithoutSkating) {
  std::mt19937 random(20240607);
  for (int i = 0; i < 60; ++i) {
    const Clip clip = walk(random_style(random), 60.0, standard_body()).clip;
    for (const bool left : {true, false}) {
      EXPECT_LT(test::planted_travel(clip, left), 1e-3) << "style " << i;
      EXPECT_GT(test::stance_share(clip, left), 0.5) << "style " << i;
    }
    EXPECT_GT(test::lowest_point(clip), -1e-3) << "style " << i;
  }
}

TEST(Walker, KneesOfEveryHumanStyleNeitherLockNorPop) {
  std::mt19937 random(7);
  for (int i = 0; i < 60; ++i) {
    const WalkStyle style = random_style(random);
    const Clip clip = walk(style, 100.0, standard_body()).clip;
    const std::vector<double> knee = knee_flexion_deg(clip, true);
    for (size_t f = 0; f < knee.size(); ++f) {
      EXPECT_GT(knee[f], 0.5) << "style " << i << " frame " << f;
      EXPECT_LT(std::abs(knee[(f + 1) % knee.size()] - knee[f]), 10.0)
          << "style " << i << " frame " << f;
    }
    EXPECT_LT(*std::max_element(knee.begin(), knee.end()), 95.0) << "style " << i;
  }
}

TEST(Walker, SmallerBodyTakesProportionallySmallerSteps) {
  const Clip tall = walk(WalkStyle{}, 60.0, standard_body(1.75)).clip;
  const Clip small = walk(WalkStyle{}, 60.0, standard_body(1.40)).clip;
  EXPECT_NEAR(small.cycle_displacement.z(), 0.8 * tall.cycle_displacement.z(), 1e-6);
  EXPECT_GT(test::lowest_point(small), -1e-3);
  EXPECT_LT(test::planted_travel(small, true), 1e-3);
}

TEST(Walker, BodyWithCrookedUnequalLegsKeepsItsFeetToo) {
  Skeleton body = standard_body();
  body.joints[LeftKnee].offset = Vec3(0.01, -0.42, 0.015);
  body.joints[LeftAnkle].offset = Vec3(-0.01, -0.415, -0.02);
  body.joints[RightKnee].offset = Vec3(0.0, -0.435, 0.01);
  body.joints[RightToe].offset = Vec3(-0.01, -0.055, 0.12);
  const Clip clip = walk(WalkStyle{}, 60.0, body).clip;
  for (const bool left : {true, false}) EXPECT_LT(test::planted_travel(clip, left), 1e-3);
  EXPECT_GT(test::lowest_point(clip), -1e-3);
}

TEST(Walker, WiderStyleParametersShowInTheMotion) {
  const auto arm_range = [](const WalkStyle& style) {
    const Clip clip = walk(style, 60.0, standard_body()).clip;
    std::vector<double> swing;
    for (const Pose& pose : clip.poses) {
      const std::vector<Vec3> joints = world_positions(clip.body, pose);
      const Vec3 arm = joints[LeftElbow] - joints[LeftShoulder];
      swing.push_back(std::atan2(arm.z(), -arm.y()) / radians_per_degree);
    }
    return range_of(swing);
  };
  const double narrow = arm_range(WalkStyle{.arm_swing_deg = 20.0});
  const double wide = arm_range(WalkStyle{.arm_swing_deg = 50.0});
  EXPECT_NEAR(narrow, 20.0, 6.0);
  EXPECT_NEAR(wide, 50.0, 8.0);
}

TEST(Walker, RefusesStepsLongerThanTheLegs) {
  try {
    walk(WalkStyle{.speed_m_s = 4.0, .cadence_steps_min = 100.0}, 30.0, standard_body());
    FAIL() << "steps of 2.4 m were accepted";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("too long"), std::string::npos) << error.what();
  }
}

TEST(Walker, RefusesStylesThatAreNoWalk) {
  const Skeleton body = standard_body();
  EXPECT_THROW(walk(WalkStyle{.speed_m_s = 0.0}, 30.0, body), Error);
  EXPECT_THROW(walk(WalkStyle{.cadence_steps_min = -1.0}, 30.0, body), Error);
  EXPECT_THROW(walk(WalkStyle{.stance_share = 0.45}, 30.0, body), Error);
  EXPECT_THROW(walk(WalkStyle{.stance_share = 0.95}, 30.0, body), Error);
  EXPECT_THROW(walk(WalkStyle{}, 0.0, body), Error);
}

}  // namespace
}  // namespace mien::motion
