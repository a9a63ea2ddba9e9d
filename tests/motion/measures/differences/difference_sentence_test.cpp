#include "motion/measures/differences/difference_sentence.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "motion/changed_motion.h"
#include "motion/gait/contact.h"
#include "motion/skeleton/mirror.h"

namespace mien::motion {
namespace {

using namespace mien::test;

std::string told(const Clip& before, const Clip& now) {
  return largest_change(motion_difference(before, now, {.lint = false, .lint_options = {}}));
}

TEST(LargestChange, NamesThePartWhatItDoesAndWhen) {
  const Clip walk = changeable_walk();  // 30 frames a second
  const BoneAxes axes = bone_axes(walk.body)[LeftElbow];
  EXPECT_EQ(told(walk, with_turn(walk, LeftElbow, axes.along, degree, 13, 13)),
            "left forearm twisted by up to 1.0°, at 0.43 s");
  EXPECT_EQ(told(walk, with_turn(walk, RightElbow, Vec3::UnitY(), 0.25 * degree, 30, 30)),
            "right forearm bent by up to 0.25°, at 1.00 s");
  EXPECT_EQ(told(walk, with_turn(walk, Chest, Vec3(0, 1, 1), 2 * degree, 3, 3)),
            "chest turned by up to 2.0°, at 0.10 s");
}

TEST(LargestChange, KnowsWhatFilesRound) {
  const Clip walk = changeable_walk();
  EXPECT_EQ(told(walk, with_turn(walk, Spine, Vec3(1, 0, 0), 1e-6)), "no more than rounding");
}

TEST(LargestChange, CountsTheOtherCauses) {
  const Clip walk = changeable_walk();
  Clip now = with_turn(walk, Neck, Vec3(1, 0, 0), 2.0 * degree, 6, 6);
  now = with_turn(now, LeftWrist, Vec3(0, 0, 1), degree, 3, 3);
  EXPECT_EQ(told(walk, now), "neck bent by up to 2.0°, at 0.20 s (and 1 other joint)");
}

TEST(LargestChange, TellsWhatHappenedToTheWholeMotionFirst) {
  const Clip walk = with_turn(changeable_walk(), LeftShoulder, Vec3(0, 0, 1), 0.5);
  EXPECT_EQ(told(walk, walk), "no difference");
  EXPECT_EQ(told(walk, without_first(walk, 1)), "the motion comes 1 frame (0.03 s) earlier");
  EXPECT_EQ(told(walk, mirrored(walk)), "the motion is mirrored: left and right are swapped");
  EXPECT_EQ(told(walk, set_elsewhere(walk, Vec3(0.1, 0, 0), 0.0)),
            "the figure is displaced by up to 10.0 cm; its poses are unchanged");
  EXPECT_EQ(told(walk, without_last(walk, 2)), std::to_string(walk.frame_count() - 2) +
                                                   " frames instead of " +
                                                   std::to_string(walk.frame_count()));
  Clip slower = walk;
  slower.frames_per_second = 24;
  EXPECT_EQ(told(walk, slower), "the same frames, played at 24 instead of 30 per second");
}

TEST(LargestChange, TellsAFootThatSlides) {
  const Clip walk = changeable_walk();
  for (const FootPlant& plant : foot_plants(walk)) {
    if (!plant.left || plant.first < 5) continue;
    const std::string text = told(walk, with_sliding_foot(walk, plant, Vec3(0.005, 0, 0)));
    EXPECT_NE(text.find("; left foot slides up to 0.5 cm while planted, at "), std::string::npos)
        << text;
    return;
  }
  FAIL() << "no stand";
}

TEST(Amounts, AreToldAsPeopleSayThem) {
  EXPECT_EQ(in_degrees(degree), "1.0°");
  EXPECT_EQ(in_degrees(0.25 * degree), "0.25°");
  EXPECT_EQ(in_degrees(1e-7), "under 0.001°");
  EXPECT_EQ(in_degrees(-12.34 * degree), "-12.3°");
  EXPECT_EQ(in_centimetres(0.123), "12.3 cm");
  EXPECT_EQ(in_centimetres(0.0025), "0.25 cm");
  EXPECT_EQ(in_centimetres(0.0), "0 cm");
  EXPECT_EQ(in_seconds(0.434), "0.43 s");
}

TEST(LargestChange, TellsFramesThatWereLeftOutOrTurnedRound) {
  const Clip walk = with_turn(changeable_walk(), LeftShoulder, Vec3(0, 0, 1), 0.5);
  Clip few = walk;
  few.poses.clear();
  for (std::size_t i = 0; i < walk.poses.size(); i += 2) few.poses.push_back(walk.poses[i]);
  few.frames_per_second = 15;
  EXPECT_EQ(told(walk, few), "only every second frame, 15 instead of 30 per second");
  EXPECT_EQ(told(few, walk),
            "each frame of before is every second one now, 30 instead of 15 per second");
  Clip back = walk;
  std::ranges::reverse(back.poses);
  EXPECT_EQ(told(walk, back), "the same frames in reverse order");
}

/// The walk on a rig whose first joint stays where it is, and whose hips go.
Clip with_root_above(const Clip& walk) {
  Clip clip = walk;
  for (Joint& joint : clip.body.joints) ++joint.parent;
  clip.body.joints.insert(clip.body.joints.begin(), Joint{"World", -1, Vec3::Zero(), {}});
  for (Pose& pose : clip.poses) {
    pose.offsets.clear();
    for (const Joint& joint : clip.body.joints) pose.offsets.push_back(joint.offset);
    pose.offsets[1] = pose.root_position;
    pose.root_position = Vec3::Zero();
    pose.rotations.insert(pose.rotations.begin(), Quat::Identity());
  }
  return clip;
}

TEST(LargestChange, TakesTheWayOfHipsBelowARootForNoBone) {
  const Clip walk = with_root_above(changeable_walk());
  Clip now = walk;
  for (Pose& pose : now.poses) pose.offsets[1].x() += 0.5;
  EXPECT_EQ(told(walk, now), "the figure is displaced by up to 50.0 cm; its poses are unchanged");
  for (Pose& pose : now.poses)
    pose.rotations[LeftElbow + 1] =
        pose.rotations[LeftElbow + 1] * Quat(Eigen::AngleAxisd(0.1, Vec3::UnitY()));
  const std::string text = told(walk, now);
  EXPECT_EQ(text.find("LeftElbow "), 0U) << text;
  EXPECT_NE(text.find("; the figure is displaced by up to 50.0 cm"), std::string::npos) << text;
}

}  // namespace
}  // namespace mien::motion
