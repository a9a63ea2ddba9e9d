#include "motion/rig/rig_motion.h"

#include <gtest/gtest.h>

#include "motion/other_rigs.h"
#include "motion/rig/rig_names.h"
#include "motion/synthetic_walk.h"

namespace mien::motion {
namespace {

using namespace mien::test;

struct Walk {
  Recording recording = to_recording(synthetic_clip(steady_walk(1.2, 1.0)));
  MappedJoints joints =
      groups_of(recording.skeleton, *key_joints_by_name(recording.skeleton), 1.0, "name");
};

TEST(RigMotion, IsTurnedUpright) {
  Walk walk;
  walk.recording = turned(walk.recording, about(Vec3::UnitX(), pi / 2));
  const UpAxis up = up_axis(world_frames(walk.recording), walk.joints);
  EXPECT_NEAR((up.axis - Vec3::UnitZ()).norm(), 0.0, 1e-12);
  EXPECT_GT(up.clearness, 0.95);
  const RigMotion motion = rig_motion(walk.recording, walk.joints, turn_to_y_up(up.axis));
  const JointTransforms& frame = motion.frames[30];
  EXPECT_GT(motion.point(frame, Head).y(), motion.point(frame, Pelvis).y() + 0.5);
}

TEST(RigMotion, TurnsEveryAxisToY) {
  for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0),
                           Vec3(0, 0, 1), Vec3(0, 0, -1)}) {
    EXPECT_NEAR((turn_to_y_up(axis) * axis - Vec3::UnitY()).norm(), 0.0, 1e-12);
  }
}

TEST(RigMotion, MeasuresTheLeg) {
  const Walk walk;
  const RigMotion motion = rig_motion(walk.recording, walk.joints, Quat::Identity());
  EXPECT_NEAR(leg_length(motion), 0.85, 1e-9);
}

TEST(RigMotion, SkipsWhatTheRigLacks) {
  Walk walk;
  walk.joints[Spine] = {};
  walk.joints[Chest] = {};
  const RigMotion motion = rig_motion(walk.recording, walk.joints, Quat::Identity());
  EXPECT_EQ(next_present(motion, Pelvis), Neck);
  EXPECT_EQ(next_present(motion, LeftHip), LeftKnee);
  EXPECT_FALSE(next_present(motion, Head));
}

TEST(RigMotion, FindsTheFarEndOfHandsAndHeads) {
  const Walk walk;
  const RigMotion motion = rig_motion(walk.recording, walk.joints, Quat::Identity());
  EXPECT_NEAR((far_end(motion, Head) - Vec3(0, 0.17, 0)).norm(), 0.0, 1e-9);
  // From the shoulder it is the finger tips.
  EXPECT_GT(far_end(motion, LeftShoulder).norm(), 0.6);
}

}  // namespace
}  // namespace mien::motion
