#include "motion/skeleton/simultaneous_frames.h"

#include <gtest/gtest.h>

namespace mien::motion {
namespace {

/// Frames of a recording, each with its number as the height of the root.
Clip frames_from(int first, int count) {
  Clip clip;
  clip.body.joints.resize(1);
  for (int frame = first; frame < first + count; ++frame) {
    Pose pose;
    pose.root_position.y() = frame;
    pose.rotations.resize(1, Quat::Identity());
    clip.poses.push_back(pose);
  }
  return clip;
}

TEST(SimultaneousFrames, AreTheSameMomentsInAllClips) {
  const std::vector<int> firsts = {3, 10, 0};
  std::vector<Clip> clips = {frames_from(3, 30), frames_from(10, 12), frames_from(0, 40)};
  ASSERT_TRUE(cut_to_simultaneous_frames(clips, firsts));
  for (const Clip& clip : clips) {
    ASSERT_EQ(clip.frame_count(), 12);
    for (int frame = 0; frame < 12; ++frame)
      EXPECT_EQ(clip.poses[static_cast<std::size_t>(frame)].root_position.y(), 10 + frame);
  }
}

TEST(SimultaneousFrames, MayBeOneOrNone) {
  const std::vector<int> meeting = {0, 4};
  std::vector<Clip> clips = {frames_from(0, 5), frames_from(4, 9)};
  ASSERT_TRUE(cut_to_simultaneous_frames(clips, meeting));
  EXPECT_EQ(clips[0].frame_count(), 1);
  EXPECT_EQ(clips[1].poses.front().root_position.y(), 4);

  const std::vector<int> apart = {0, 5};
  clips = {frames_from(0, 5), frames_from(5, 9)};
  EXPECT_FALSE(cut_to_simultaneous_frames(clips, apart));
  EXPECT_EQ(clips[0].frame_count(), 5);
  EXPECT_EQ(clips[1].frame_count(), 9);
}

}  // namespace
}  // namespace mien::motion
