#include <gtest/gtest.h>

#include "motion/other_rigs.h"
#include "motion/random_recording.h"
#include "motion/rig/recording_clip.h"
#include "motion/synthetic_walk.h"

namespace mien::motion {
namespace {

TEST(RecordingInMetres, IsAsLargeAndUprightAsThePersonWasWhateverTheUnitAndAxes) {
  const Recording metres =
      to_recording(mien::test::synthetic_clip(mien::test::steady_walk(1.2, 3.0)));
  const Quat z_up(Eigen::AngleAxisd(pi / 2, Vec3::UnitX()));
  for (const double unit : {1.0, 100.0, 1.0 / 0.0254}) {
    for (const Quat& turn : {Quat(Quat::Identity()), z_up}) {
      Recording other = mien::test::turned(mien::test::scaled(metres, unit), turn);
      other.format = "bvh";
      EXPECT_LT(mien::test::largest_joint_distance(in_metres(other), metres), 1e-6) << unit;
    }
  }
}

TEST(RecordingInMetres, KeepsJointsThatMoveOnTheirParents) {
  Recording metres = to_recording(mien::test::synthetic_clip(mien::test::steady_walk(1.2, 3.0)));
  for (Pose& pose : metres.poses) {
    for (const Joint& joint : metres.skeleton.joints) pose.offsets.push_back(1.01 * joint.offset);
  }
  Recording other = mien::test::scaled(metres, 100.0);
  other.format = "bvh";
  EXPECT_LT(mien::test::largest_joint_distance(in_metres(other), metres), 1e-6);
}

}  // namespace
}  // namespace mien::motion
