#include "motion/biomechanics/joint_angles.h"

#include <gtest/gtest.h>

#include "motion/lint/injected_faults.h"
#include "motion/skeleton/mirror.h"

namespace mien::motion {
namespace {

using namespace mien::test;

Pose rest_pose() {
  Pose pose;
  pose.rotations.assign(body_joint_count, Quat::Identity());
  return pose;
}

Quat turn(const Vec3& axis, double degrees) {
  return Quat(Eigen::AngleAxisd(degrees * radians_per_degree, axis));
}

double value_of(const Pose& pose, BodyJoint joint, const std::string& name) {
  const std::vector<double> values = measured_angles(pose);
  for (size_t a = 0; a < values.size(); ++a) {
    if (joint_angles()[a].joint == joint && joint_angles()[a].name == name) return values[a];
  }
  ADD_FAILURE() << name_of(joint) << " " << name;
  return 0.0;
}

TEST(JointAngles, HaveNoWiderRangeWithoutLoad) {
  for (const JointAngle& angle : joint_angles()) {
    EXPECT_LE(angle.most_free_degrees, angle.most_degrees) << angle.name;
    EXPECT_LT(angle.least_degrees, angle.most_free_degrees) << angle.name;
    EXPECT_EQ(&joint_angle(angle.joint, angle.name), &angle);
  }
}

TEST(JointAngles, AreNoneAtRest) {
  const std::vector<double> values = measured_angles(rest_pose());
  ASSERT_EQ(values.size(), joint_angles().size());
  for (size_t a = 0; a < values.size(); ++a) {
    // Arms point outward at rest.
    const double expected = joint_angles()[a].name == "adduction" ? -90.0 : 0.0;
    EXPECT_NEAR(values[a], expected, 1e-9) << joint_angles()[a].name;
  }
}

TEST(JointAngles, AreWhatTheJointWasTurnedBy) {
  struct Case {
    BodyJoint joint;
    Vec3 axis;
    double degrees;
    const char* angle;
    double expected;
  };
  const Vec3 x = Vec3::UnitX();
  const Vec3 y = Vec3::UnitY();
  const Vec3 z = Vec3::UnitZ();
  const std::vector<Case> cases = {
      {LeftKnee, x, 60, "flexion", 60},
      {RightKnee, x, -20, "flexion", -20},
      {LeftKnee, z, 20, "sideways bend", 20},
      {LeftElbow, y, -70, "flexion", 70},
      {RightElbow, y, 70, "flexion", 70},
      {RightElbow, y, -15, "flexion", -15},
      {LeftHip, x, -40, "flexion", 40},
      {RightHip, x, 20, "flexion", -20},
      {LeftHip, z, 30, "abduction", 30},
      {RightHip, z, -30, "abduction", 30},
      {LeftHip, y, 25, "rotation", 25},
      {LeftAnkle, x, -15, "dorsiflexion", 15},
      {RightAnkle, x, 40, "dorsiflexion", -40},
      {Chest, x, 35, "flexion", 35},
      {Spine, z, 10, "lateral flexion", 10},
      {Chest, y, -30, "rotation", 30},
      {Head, x, 25, "flexion", 25},
      {Neck, y, 50, "rotation", 50},
      {LeftShoulder, y, 40, "extension", 40},
      {RightShoulder, y, -40, "extension", 40},
      {LeftShoulder, y, -150, "adduction", 60},
  };
  for (const Case& one : cases) {
    Pose pose = rest_pose();
    pose.rotations[one.joint] = turn(one.axis, one.degrees);
    const BodyJoint told = one.joint == Spine ? Chest : one.joint == Neck ? Head : one.joint;
    EXPECT_NEAR(value_of(pose, told, one.angle), one.expected, 1e-9)
        << name_of(one.joint) << " " << one.angle;
  }
}

TEST(JointAngles, AreTheSameOfTheMirrorImage) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> angle(-0.8, 0.8);
  for (int i = 0; i < 50; ++i) {
    Clip clip;
    clip.body = standard_body();
    clip.poses = {rest_pose()};
    for (Quat& rotation : clip.poses[0].rotations) {
      rotation = exp(Vec3(angle(random), angle(random), angle(random)));
    }
    const Pose mirror = mirrored(clip).poses[0];
    for (const JointAngle& one : joint_angles()) {
      EXPECT_NEAR(value_of(clip.poses[0], one.joint, std::string(one.name)),
                  value_of(mirror, mirrored(one.joint), std::string(one.name)), 1e-9)
          << name_of(one.joint) << " " << one.name;
    }
  }
}

TEST(JointLimits, EveryAngleBeyondItsRangeIsAnError) {
  const std::vector<std::pair<BodyJoint, Vec3>> bends = {
      {LeftElbow, Vec3(0, 30, 0)},    {RightElbow, Vec3(0, -30, 0)},   {LeftKnee, Vec3(-30, 0, 0)},
      {LeftKnee, Vec3(0, 0, 40)},     {RightHip, Vec3(50, 0, 0)},      {LeftHip, Vec3(0, 0, 70)},
      {LeftHip, Vec3(0, 70, 0)},      {RightHip, Vec3(0, 0, 50)},      {LeftAnkle, Vec3(-60, 0, 0)},
      {RightAnkle, Vec3(80, 0, 0)},   {Head, Vec3(80, 0, 0)},          {Head, Vec3(-90, 0, 0)},
      {Head, Vec3(0, 0, 70)},         {Head, Vec3(0, 110, 0)},         {Chest, Vec3(100, 0, 0)},
      {Chest, Vec3(-60, 0, 0)},       {Chest, Vec3(0, 0, 65)},         {Chest, Vec3(0, 70, 0)},
      {LeftShoulder, Vec3(0, 80, 0)}, {RightShoulder, Vec3(0, 170, 0)}};
  for (const auto& [joint, degrees] : bends) {
    Clip clip;
    clip.body = standard_body();
    clip.poses.assign(40, rest_pose());
    for (Pose& pose : clip.poses) {
      pose.root_position.y() = 0.96;
      pose.rotations[joint] = exp(degrees * radians_per_degree);
    }
    EXPECT_TRUE(find_error(lint(clip), "joint-limit", std::string(name_of(joint))))
        << name_of(joint) << " " << degrees.transpose() << "\n"
        << all_of(lint(clip));
    // What the original did is no fault.
    EXPECT_FALSE(find(lint(clip, {}, &clip), "joint-limit")) << name_of(joint);
  }
}

TEST(JointLimits, WristThatTurnsBackFromItsUsualAttitudeIsAnError) {
  Clip clip = three_cycles(builtin_walks()[0]);
  for (int t = 20; t < 35; ++t) {
    clip.poses[t].rotations[RightWrist] = exp(Vec3(0, 0, 2.1 * bump(t, 20, 34)));
  }
  EXPECT_TRUE(find_error(lint(clip), "joint-limit", "RightWrist", 20, 34));
  EXPECT_FALSE(find(lint(clip), "joint-limit", "LeftWrist"));
}

}  // namespace
}  // namespace mien::motion
