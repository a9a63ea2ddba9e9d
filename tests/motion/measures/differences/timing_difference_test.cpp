#include "motion/measures/differences/timing_difference.h"

#include <gtest/gtest.h>

#include "motion/changed_motion.h"

namespace mien::motion {
namespace {

using namespace mien::test;

TimingDifference timing(const Clip& before, const Clip& now) {
  return timing_difference(before, now, paired(before, now));
}

/// The frame that a clip begins with, held so much longer.
Clip begun_later(Clip clip, int frames) {
  clip.poses.insert(clip.poses.begin(), frames, clip.poses.front());
  return clip;
}

TEST(TimingDifference, OfAMotionToItselfTellsNothing) {
  const Clip walk = changeable_walk();
  const TimingDifference same = timing(walk, walk);
  EXPECT_TRUE(same.same_length());
  EXPECT_FALSE(same.shift || same.gap || same.other_pace);
}

TEST(TimingDifference, TellsAMotionThatComesAFrameEarlierOrLater) {
  const Clip walk = changeable_walk();
  for (const int frames : {1, 2, 7}) {
    const TimingDifference earlier = timing(walk, without_first(walk, frames));
    ASSERT_TRUE(earlier.shift);
    EXPECT_EQ(earlier.shift->frames, -frames);
    EXPECT_NEAR(earlier.shift->seconds, -frames / walk.frames_per_second, 1e-12);
    EXPECT_NEAR(earlier.shift->explained, 1.0, 1e-12);
    EXPECT_TRUE(earlier.shift->path_too);
    const TimingDifference later = timing(without_first(walk, frames), walk);
    ASSERT_TRUE(later.shift);
    EXPECT_EQ(later.shift->frames, frames);
  }
}

TEST(TimingDifference, TellsAShiftInAsManyFrames) {
  const Clip walk = changeable_walk();
  const TimingDifference found = timing(without_last(walk, 1), without_first(walk, 1));
  EXPECT_TRUE(found.same_length());
  ASSERT_TRUE(found.shift);
  EXPECT_EQ(found.shift->frames, -1);
}

TEST(TimingDifference, TellsAShiftOfAClipThatHoldsItsFirstFrame) {
  const Clip walk = changeable_walk();
  const TimingDifference found = timing(walk, begun_later(without_last(walk, 1), 1));
  ASSERT_TRUE(found.shift);
  EXPECT_EQ(found.shift->frames, 1);
}

TEST(TimingDifference, TellsAShiftOfPosesOnAPathOfItsOwn) {
  const Clip walk = changeable_walk();
  Clip now = without_first(walk, 2);
  const Vec3 start = now.poses.front().root_position - walk.poses.front().root_position;
  for (Pose& pose : now.poses) pose.root_position -= horizontal(start) + Vec3(0.5, 0, 0.2);
  const TimingDifference found = timing(walk, now);
  ASSERT_TRUE(found.shift);
  EXPECT_EQ(found.shift->frames, -2);
  EXPECT_FALSE(found.shift->path_too);
}

TEST(TimingDifference, TellsAShiftRoundTheSeamOfALoop) {
  const Clip& loop = changeable_loop();
  Clip now = loop;
  std::rotate(now.poses.begin(), now.poses.begin() + 3, now.poses.end());
  for (int t = now.frame_count() - 3; t < now.frame_count(); ++t)
    now.poses[t].root_position += loop.cycle_displacement;
  const TimingDifference found = timing(loop, now);
  ASSERT_TRUE(found.shift);
  EXPECT_EQ(found.shift->frames, -3);
  EXPECT_GT(found.shift->explained, 1.0 - 1e-9);
}

TEST(TimingDifference, TellsTheSmallestShiftOfAMotionThatRepeats) {
  const Clip& loop = changeable_loop();
  Clip on_the_spot = loop;
  on_the_spot.cycle_displacement.setZero();
  for (Pose& pose : on_the_spot.poses) pose.root_position = Vec3(0, pose.root_position.y(), 0);
  const Clip walk = repeated(on_the_spot, 4);
  const TimingDifference found = timing(walk, without_first(walk, 2));
  ASSERT_TRUE(found.shift);
  EXPECT_EQ(found.shift->frames, -2);
}

TEST(TimingDifference, DoesNotCallAChangedPoseAShift) {
  const Clip walk = changeable_walk();
  for (const double degrees : {0.1, 1.0, 20.0}) {
    const Clip now = with_turn(walk, LeftShoulder, Vec3(1, 0, 0), degrees * radians_per_degree);
    const TimingDifference found = timing(walk, now);
    EXPECT_FALSE(found.shift || found.gap || found.other_pace);
  }
  const TimingDifference moved = timing(walk, set_elsewhere(walk, Vec3(0, 0, 0.04), 0.0));
  EXPECT_FALSE(moved.shift || moved.gap);
}

TEST(TimingDifference, TellsWhereAFrameWasLeftOut) {
  const Clip walk = changeable_walk();
  const int middle = walk.frame_count() / 2;
  Clip now = walk;
  now.poses.erase(now.poses.begin() + middle);
  const TimingDifference found = timing(walk, now);
  EXPECT_FALSE(found.shift);
  ASSERT_TRUE(found.gap);
  EXPECT_EQ(found.gap->frames, -1);
  EXPECT_EQ(found.gap->frame, middle);
  now.poses.push_back(now.poses.back());  // as many frames as before
  const TimingDifference held = timing(walk, now);
  ASSERT_TRUE(held.gap);
  EXPECT_EQ(held.gap->frame, middle);
  EXPECT_EQ(held.gap->frames, -1);
}

TEST(TimingDifference, TellsWhereFramesCameIn) {
  const Clip walk = changeable_walk();
  const int middle = walk.frame_count() / 2;
  Clip now = walk;
  now.poses.insert(now.poses.begin() + middle, 5, now.poses[middle]);
  const TimingDifference found = timing(walk, now);
  ASSERT_TRUE(found.gap);
  EXPECT_EQ(found.gap->frames, 5);
  EXPECT_NEAR(found.gap->frame, middle, 1);
}

TEST(TimingDifference, TellsTheSameFramesAtAnotherPace) {
  const Clip walk = changeable_walk();
  Clip now = walk;
  now.frames_per_second *= 0.8;
  const TimingDifference found = timing(walk, now);
  EXPECT_TRUE(found.other_pace);
  EXPECT_FALSE(found.shift || found.gap);
  EXPECT_FALSE(found.same_length());
}

TEST(TimingDifference, OfAMotionAtAnotherRateIsItsRateAlone) {
  const Clip walk = changeable_walk();
  const TimingDifference found = timing(walk, resampled(walk, 2.0 * walk.frames_per_second));
  EXPECT_FALSE(found.other_pace || found.shift || found.gap);
  EXPECT_NEAR(found.now.frames_per_second, 2.0 * found.before.frames_per_second, 1e-12);
}

}  // namespace
}  // namespace mien::motion
