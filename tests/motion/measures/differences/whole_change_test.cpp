#include "motion/measures/differences/whole_change.h"

#include <gtest/gtest.h>

#include "motion/changed_motion.h"
#include "motion/skeleton/mirror.h"

namespace mien::motion {
namespace {

using namespace mien::test;

WholeBodyChange whole(const Clip& before, const Clip& now) {
  return whole_change(paired(before, now), before.body, now.body);
}

/// A walk whose sides do different things.
Clip lopsided_walk() { return with_turn(changeable_walk(), LeftShoulder, Vec3(0, 0, 1), 0.5); }

/// Left and right trade the rotations of their joints as they are.
Clip with_swapped_turns(Clip clip) {
  for (Pose& pose : clip.poses) {
    const std::vector<Quat> turns = pose.rotations;
    for (int j = 0; j < body_joint_count; ++j) pose.rotations[j] = turns[mirrored(BodyJoint(j))];
  }
  return clip;
}

TEST(WholeChange, IsNoneForWhatStaysOrChangesInPart) {
  const Clip walk = lopsided_walk();
  EXPECT_EQ(whole(walk, walk).kind, WholeChange::none);
  for (const double radians : {0.02, 0.5, 1.5}) {
    const Clip now = with_turn(walk, RightHip, Vec3(1, 0, 0), radians);
    EXPECT_EQ(whole(walk, now).kind, WholeChange::none) << radians;
  }
}

TEST(WholeChange, TellsTheMoveOfAFigureThatStandsElsewhere) {
  const Clip walk = lopsided_walk();
  const WholeBodyChange moved = whole(walk, set_elsewhere(walk, Vec3(0.1, 0.02, -0.3), 0.2));
  EXPECT_EQ(moved.kind, WholeChange::moved);
  EXPECT_NEAR(moved.turn_radians, 0.2, 1e-9);
  EXPECT_TRUE(moved.shift.isApprox(Vec3(0.1, 0.02, -0.3), 1e-9));
  EXPECT_LT(moved.remaining, 1e-9);
}

TEST(WholeChange, TellsAMirroredMotionWhereverItStands) {
  const Clip walk = lopsided_walk();
  const Clip mirror = mirrored(walk);
  EXPECT_EQ(whole(walk, mirror).kind, WholeChange::mirrored);
  EXPECT_EQ(whole(walk, set_elsewhere(mirror, Vec3(2, 0, 1), 1.0)).kind, WholeChange::mirrored);
  EXPECT_LT(whole(walk, mirror).remaining, 1e-9);
  EXPECT_GT(whole(walk, mirror).before, 0.01);
}

TEST(WholeChange, TellsSidesThatChangedTheirNames) {
  const Clip walk = lopsided_walk();
  Clip now = walk;
  for (Joint& joint : now.body.joints) {
    const int there = find_joint(walk.body, joint.name);
    joint.name = name_of(mirrored(BodyJoint(there)));
  }
  EXPECT_EQ(whole(walk, now).kind, WholeChange::renamed_sides);
}

TEST(WholeChange, TellsSidesThatHaveEachOthersRotations) {
  const Clip walk = lopsided_walk();
  EXPECT_EQ(whole(walk, with_swapped_turns(walk)).kind, WholeChange::swapped_turns);
}

TEST(WholeChange, TellsOtherUnits) {
  const Clip walk = lopsided_walk();
  for (const double factor : {0.01, 0.0254, 2.54, 10.0, 100.0}) {
    Clip now = walk;
    for (Joint& joint : now.body.joints) joint.offset *= factor;
    for (Pose& pose : now.poses) pose.root_position *= factor;
    const WholeBodyChange change = whole(walk, now);
    EXPECT_EQ(change.kind, WholeChange::scaled) << factor;
    EXPECT_NEAR(change.scale, factor, 1e-9 * factor);
    now = with_turn(now, LeftShoulder, Vec3(0, 0, 1), 1.0);
    EXPECT_NE(whole(walk, now).kind, WholeChange::scaled) << factor;
  }
}

TEST(WholeChange, TellsABodyInsideOut) {
  const Clip walk = lopsided_walk();
  Clip now = walk;
  for (Joint& joint : now.body.joints) joint.offset = mirrored_place(joint.offset);
  for (Pose& pose : now.poses) {
    pose.root_position = mirrored_place(pose.root_position);
    for (Quat& q : pose.rotations) q = Quat(q.w(), q.x(), -q.y(), -q.z());
  }
  EXPECT_EQ(whole(walk, now).kind, WholeChange::flipped);
}

TEST(RootDifference, PartsThePlacingOfTheBody) {
  const Clip walk = changeable_walk();
  Clip now = set_elsewhere(walk, Vec3::Zero(), 0.0);
  const Quat turn(Eigen::AngleAxisd(0.1, Vec3::UnitY()));
  for (Pose& pose : now.poses) {
    pose.root_position += Vec3(0.03, -0.02, 0.04);
    pose.rotations[Pelvis] = turn * pose.rotations[Pelvis];
  }
  const RootDifference root = root_difference(paired(walk, now), walk.body);
  EXPECT_EQ(root.joint, Pelvis);
  for (size_t t = 0; t < walk.poses.size(); ++t) {
    EXPECT_NEAR(root.path_m[t], 0.05, 1e-12);
    EXPECT_NEAR(root.height_m[t], 0.02, 1e-12);
    EXPECT_NEAR(root.heading_radians[t], 0.1, 1e-12);
    EXPECT_NEAR(root.tilt_radians[t], 0.0, 1e-12);
  }
}

}  // namespace
}  // namespace mien::motion
