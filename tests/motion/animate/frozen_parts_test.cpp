#include "motion/animate/frozen_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "motion/gait/contact.h"
#include "motion/handed_motion.h"
#include "motion/math/rotation.h"
#include "motion/refusal.h"

#include "animated_motions.h"

namespace mien::motion {
namespace {

using namespace mien::test;

bool is_leg(int joint) { return joint == Pelvis || joint >= LeftHip; }

TEST(FrozenArms, HoldTheirFingers) {
  std::mt19937_64 random(3);
  const Clip walk = with_moving_fingers(walk_of(), random);
  const Clip frozen = with_frozen(walk, {.parts = {FrozenPart::left_arm}}).clip;
  for (std::size_t f = 0; f < walk.poses.size(); ++f) {
    for (int joint = 0; joint < finger_joint_count; ++joint) {
      const auto j = static_cast<std::size_t>(joint);
      const Pose& expected = is_left_finger(joint) ? frozen.poses.front() : walk.poses[f];
      EXPECT_EQ(frozen.poses[f].fingers[j].coeffs(), expected.fingers[j].coeffs());
    }
  }
  EXPECT_EQ(largest_finger_turn(with_frozen(walk, {.parts = {FrozenPart::legs}}).clip.poses[9],
                                walk.poses[9]),
            0.0);
}

TEST(FrozenLegs, StandWhereTheyAreAndTheRestKeepsItsRotations) {
  const Clip walk = walk_of();
  const AnimatedClip frozen = with_frozen(walk, {.parts = {FrozenPart::legs}});
  const auto contact = [&](bool left, std::size_t f) -> bool {
    return foot_contact(walk, left).foot[f];
  };
  std::size_t held = walk.poses.size();
  for (std::size_t f = 0; f < walk.poses.size(); ++f) {
    const Pose& pose = frozen.clip.poses[f];
    EXPECT_EQ(pose.root_position, frozen.clip.poses.front().root_position);
    for (int joint = 0; joint < body_joint_count; ++joint) {
      const auto j = static_cast<std::size_t>(joint);
      if (is_leg(joint))
        EXPECT_EQ(pose.rotations[j].coeffs(), frozen.clip.poses.front().rotations[j].coeffs());
      else
        EXPECT_EQ(pose.rotations[j].coeffs(), walk.poses[f].rotations[j].coeffs());
    }
    // It is the pose of a frame of the motion.
    bool is_this = pose.root_position == walk.poses[f].root_position;
    for (int joint = 0; joint < body_joint_count; ++joint)
      if (is_leg(joint))
        is_this = is_this && pose.rotations[static_cast<std::size_t>(joint)].coeffs() ==
                                 walk.poses[f].rotations[static_cast<std::size_t>(joint)].coeffs();
    if (is_this) held = f;
  }
  ASSERT_LT(held, walk.poses.size());
  EXPECT_TRUE(contact(true, held) && contact(false, held)) << held;
  ASSERT_EQ(frozen.remarks.size(), 1u);
  EXPECT_TRUE(frozen.remarks[0].starts_with("the legs do not move, in the pose at "));
}

TEST(FrozenLegs, OfALoopStayOnTheSpot) {
  const Clip walk = motion::walk({}, 100.0, standard_body()).clip;
  ASSERT_TRUE(walk.loops);
  const Clip frozen = with_frozen(walk, {.parts = {FrozenPart::legs}}).clip;
  EXPECT_TRUE(frozen.loops);
  EXPECT_EQ(frozen.cycle_displacement, Vec3::Zero());
}

TEST(FrozenParts, KeepThePoseOfAMoment) {
  const Clip walk = natural_walk();
  const std::array<std::pair<FrozenPart, std::array<int, 4>>, 4> parts = {
      {{FrozenPart::trunk, {Spine, Chest, Spine, Chest}},
       {FrozenPart::head, {Neck, Head, Neck, Head}},
       {FrozenPart::left_arm, {LeftClavicle, LeftShoulder, LeftElbow, LeftWrist}},
       {FrozenPart::right_arm, {RightClavicle, RightShoulder, RightElbow, RightWrist}}}};
  for (const auto& [part, joints] : parts) {
    const Clip frozen = with_frozen(walk, {.parts = {part}, .at = Moment{37, true}}).clip;
    for (std::size_t f = 0; f < walk.poses.size(); ++f) {
      EXPECT_EQ(frozen.poses[f].root_position, walk.poses[f].root_position);
      for (int joint = 0; joint < body_joint_count; ++joint) {
        const auto j = static_cast<std::size_t>(joint);
        const bool is_frozen = std::ranges::find(joints, joint) != joints.end();
        EXPECT_LT(frozen.poses[f].rotations[j].angularDistance(
                      walk.poses[is_frozen ? 37 : f].rotations[j]),
                  1e-12);
      }
    }
  }
}

TEST(FrozenParts, KeepTheirMostTypicalPose) {
  // Nine of ten frames alike, up to a little, and one far from them.
  Clip clip = walk_of(0.2, 50.0);
  for (std::size_t f = 0; f < clip.poses.size(); ++f)
    clip.poses[f].rotations[Head] = Quat(Eigen::AngleAxisd(
        f == 4 ? 1.2 : 0.3 + 0.01 * static_cast<double>(f % 3 == 0), Vec3::UnitX()));
  const Clip frozen = with_frozen(clip, {.parts = {FrozenPart::head}}).clip;
  const double angle = frozen.poses[0].rotations[Head].angularDistance(Quat::Identity());
  EXPECT_GE(angle, 0.3 - 1e-9);
  EXPECT_LE(angle, 0.31 + 1e-9);
  // Where the body faces does not make a pose of the legs typical: one frame faces the mean
  // direction, with a bent knee.
  Clip turned = walk_of(1.0, 50.0);
  const std::size_t odd = turned.poses.size() / 2;
  const Pose first = turned.poses[0];
  for (std::size_t f = 0; f < turned.poses.size(); ++f) {
    turned.poses[f] = first;
    const double turn = f == odd ? 0.0 : f % 2 == 0 ? 1.4 : -1.4;
    turned.poses[f].rotations[Pelvis] =
        Quat(Eigen::AngleAxisd(turn, Vec3::UnitY())) * first.rotations[Pelvis];
  }
  turned.poses[odd].rotations[LeftKnee] = Quat(Eigen::AngleAxisd(1.0, Vec3::UnitX()));
  const Clip standing = with_frozen(turned, {.parts = {FrozenPart::legs}}).clip;
  EXPECT_LT(
      standing.poses[0].rotations[LeftKnee].angularDistance(turned.poses[0].rotations[LeftKnee]),
      1e-9);
}

TEST(FrozenParts, RefuseMomentsOutsideTheMotion) {
  const Clip walk = natural_walk();
  const auto refused = [&](double seconds) {
    return refusal_of([&] {
      with_frozen(walk, {.parts = {FrozenPart::legs}, .at = Moment{seconds, false}});
    });
  };
  EXPECT_NE(refused(-0.1).find("the motion lasts"), std::string::npos);
  EXPECT_NE(refused(walk.duration_seconds() + 0.1).find("the motion lasts"), std::string::npos);
  EXPECT_NO_THROW(with_frozen(
      walk, {.parts = {FrozenPart::legs}, .at = Moment{walk.duration_seconds(), false}}));
  Clip other = walk;
  other.body.joints.resize(3);
  EXPECT_NE(
      refusal_of([&] { with_frozen(other, {.parts = {FrozenPart::legs}}); }).find("canonical"),
      std::string::npos);
}

}  // namespace
}  // namespace mien::motion
