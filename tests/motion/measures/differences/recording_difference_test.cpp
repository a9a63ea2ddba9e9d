#include "motion/measures/differences/recording_difference.h"

#include <gtest/gtest.h>

#include "motion/changed_motion.h"
#include "motion/error.h"
#include "motion/measures/differences/motion_tolerance.h"
#include "motion/other_rigs.h"
#include "motion/random_recording.h"

namespace mien::motion {
namespace {

using namespace mien::test;

/// As a file in centimetres has it.
Recording recorded(const Clip& clip) {
  Recording recording = test::scaled(to_recording(clip), 100.0);
  recording.format = "bvh";
  return recording;
}

MotionDifference difference(const Recording& before, const Recording& now) {
  return motion_difference(compared_recordings(before, now), {.lint = false, .lint_options = {}});
}

double worst(const MotionDifference& of) {
  return worst_joint(of, &JointDifference::point_m).peak.value;
}

TEST(RecordingDifference, OfARecordingToItselfIsNothing) {
  const Recording walk = recorded(changeable_walk());
  const MotionDifference none = motion_difference(compared_recordings(walk, walk));
  EXPECT_TRUE(none.identical);
  EXPECT_EQ(worst(none), 0.0);
  ASSERT_TRUE(none.body);
  EXPECT_EQ(none.body->d_m, 0.0);
  EXPECT_TRUE(none.lint.empty());
}

TEST(RecordingDifference, IsInMetresAndOnTheRigsOwnJoints) {
  const Clip walk = changeable_walk();
  Clip now = walk;
  for (Pose& pose : now.poses) pose.root_position.y() += 0.01;
  const MotionDifference raised = difference(recorded(walk), recorded(now));
  EXPECT_FALSE(raised.on_body);
  EXPECT_NEAR(worst(raised), 0.01, 1e-9);  // what a body on its own floor would not show
  EXPECT_TRUE(is_root_only(raised));
}

TEST(RecordingDifference, NamesPartsOfTheBody) {
  const Clip walk = changeable_walk();
  const Recording before = on_other_rig(walk, bones_along_x());
  Recording now = before;
  for (Pose& pose : now.poses)
    pose.rotations[LeftElbow] =
        pose.rotations[LeftElbow] * Quat(Eigen::AngleAxisd(0.02, Vec3::UnitX()));
  const MotionDifference twisted = difference(before, now);
  ASSERT_EQ(causes(twisted).size(), 1U);
  const JointDifference& joint = twisted.joints[causes(twisted).front()];
  EXPECT_EQ(joint.part, "left forearm");
  EXPECT_NEAR(peak_of(joint.twist_radians).value, 0.02, 1e-9);
}

TEST(RecordingDifference, OfTheSameMotionInAnotherFormatsUnitIsNone) {
  const Clip walk = changeable_walk();
  Recording metres = to_recording(walk);
  metres.format = "gltf";
  EXPECT_LT(worst(difference(recorded(walk), metres)), 1e-9);
}

TEST(RecordingDifference, TellsAnotherUnitInAFileOfTheSameFormat) {
  const Recording walk = recorded(changeable_walk());
  const MotionDifference grown = difference(walk, test::scaled(walk, 10.0));
  EXPECT_GT(worst(grown), 1.0);
  EXPECT_EQ(grown.remarks.size(), 1U);
}

TEST(RecordingDifference, OfOtherRigsIsThatOfTheirBodies) {
  const Clip walk = changeable_walk();
  Recording other = on_other_rig(walk, bones_along_x());
  for (Joint& joint : other.skeleton.joints) joint.name = "mocap:" + joint.name;
  const MotionDifference across = difference(to_recording(walk), other);
  EXPECT_TRUE(across.on_body);
  EXPECT_EQ(across.joints.size(), size_t{body_joint_count});
  EXPECT_LT(across.errors.mpjpe, 0.005);
}

TEST(RecordingDifference, TakesFiguresThatAreNotHuman) {
  std::mt19937_64 random(3);
  Recording creature;
  creature.name = "creature";
  creature.format = "bvh";
  creature.skeleton = random_skeleton(random, 6, 1.0);
  Pose pose;
  for (int j = 0; j < 6; ++j) pose.rotations.push_back(exp(random_vector(random, 1.0)));
  creature.poses.assign(5, pose);
  const MotionDifference same = difference(creature, creature);
  EXPECT_TRUE(same.identical);
  EXPECT_FALSE(same.body);
  EXPECT_THROW(difference(creature, to_recording(changeable_walk())), Error);
}

TEST(RecordingDifference, TellsJointsThatAreCalledOtherwise) {
  const Recording walk = recorded(changeable_walk());
  Recording now = walk;
  for (Joint& joint : now.skeleton.joints) joint.name = "mixamorig:" + joint.name;
  const MotionDifference renamed = difference(walk, now);
  EXPECT_FALSE(renamed.identical);
  EXPECT_FALSE(renamed.on_body);
  EXPECT_EQ(worst(renamed), 0.0);
  EXPECT_EQ(renamed.renamed.size(), walk.skeleton.joints.size());
  const std::vector<Excess> too_much = excesses(renamed, {});
  ASSERT_EQ(too_much.size(), 1U);
  EXPECT_EQ(too_much[0].measure, "joints");
}

}  // namespace
}  // namespace mien::motion
