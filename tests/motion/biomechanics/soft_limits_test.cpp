#include "motion/biomechanics/soft_limits.h"

#include <cmath>

#include <gtest/gtest.h>

#include "motion/biomechanics/joint_angles.h"
#include "motion/math/rotation.h"
#include "motion/modify/path_measures.h"
#include "motion/modify/posture.h"
#include "motion/procedural/walker.h"

namespace mien::motion {
namespace {

using namespace mien::test;

TEST(SoftLimits, NeverPassTheLimitAndNeverGoBack) {
  double before = -1.0;
  for (double value = 0.0; value < 5.0; value += 0.01) {
    const double limited = softly_limited(value, 1.0, 1.5);
    EXPECT_LE(limited, 1.5);
    EXPECT_GE(limited, before);
    EXPECT_LE(limited, value);
    if (value <= 1.0) {
      EXPECT_EQ(limited, value);
    }
    before = limited;
  }
  // No kink where bending begins.
  EXPECT_NEAR((softly_limited(1.0 + 1e-6, 1.0, 1.5) - 1.0) / 1e-6, 1.0, 1e-3);
}

TEST(SoftLimits, LeaveWhatTheOriginalDoes) {
  const Clip clip = walk({}, 30.0, standard_body()).clip;
  const SoftLimits limits = with_soft_limits(clip, clip);
  EXPECT_LT(largest_distance(limits.clip, clip), 1e-12);
  EXPECT_EQ(limits.largest_excess, 0.0);
}

TEST(SoftLimits, BendKneesAndElbowsOfBothSidesBack) {
  const Clip clip = walk({}, 30.0, standard_body()).clip;
  const Clip bent =
      with_posture(clip, {{PostureUnit::knee_flexion, -60.0}, {PostureUnit::elbow_flexion, -60.0}});
  const SoftLimits limits = with_soft_limits(bent, clip);
  EXPECT_GT(limits.largest_excess, 0.5);
  for (const Pose& pose : limits.clip.poses) {
    const double allowed = 3.5 * radians_per_degree;
    EXPECT_GT(log(pose.rotations[LeftKnee]).x(), -allowed);
    EXPECT_GT(log(pose.rotations[RightKnee]).x(), -allowed);
    EXPECT_LT(log(pose.rotations[LeftElbow]).y(), allowed);
    EXPECT_GT(log(pose.rotations[RightElbow]).y(), -allowed);
  }
}

TEST(SoftLimits, KeepJointsWithinTheRangesThatLintLooksAt) {
  struct Case {
    BodyJoint joint;
    const char* angle;
    Vec3 axis;
  };
  const std::vector<Case> cases = {{LeftHip, "flexion", Vec3::UnitX()},
                                   {RightHip, "abduction", Vec3::UnitZ()},
                                   {RightKnee, "flexion", Vec3::UnitX()},
                                   {LeftAnkle, "dorsiflexion", Vec3::UnitX()},
                                   {RightElbow, "flexion", Vec3::UnitY()}};
  Clip still;
  still.body = standard_body();
  still.poses.resize(1);
  still.poses[0].rotations.assign(body_joint_count, Quat::Identity());
  for (const auto& [joint, name, axis] : cases) {
    const JointAngle& angle = joint_angle(joint, name);
    const auto at = static_cast<size_t>(&angle - joint_angles().data());
    for (double degrees = -170.0; degrees <= 170.0; degrees += 10.0) {
      Clip turned = still;
      turned.poses[0].rotations[joint] = exp(degrees * radians_per_degree * axis);
      const SoftLimits limits = with_soft_limits(turned, still);
      const double value = measured_angles(limits.clip.poses[0])[at];
      const double hinge_room = 3.0;  // which a straight knee or elbow has, or it would jerk
      EXPECT_LE(value, angle.most_free_degrees + 1e-9) << name << " " << degrees;
      EXPECT_GE(value, angle.least_degrees - hinge_room - 1e-9) << name << " " << degrees;
    }
  }
}

}  // namespace
}  // namespace mien::motion
