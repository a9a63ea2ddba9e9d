#include "motion/animate/motion_ends.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "motion/error.h"
#include "motion/math/rotation.h"
#include "motion/skeleton/body.h"
#include "motion/skeleton/hand.h"

#include "animated_motions.h"

namespace mien::motion {
namespace {

using namespace mien::test;

/// Forty frames.
Clip some_walk() {
  Clip clip = walk_of(2.0, 30.0);
  clip.poses.resize(40);
  return clip;
}

void expect_same(const Pose& a, const Pose& b) {
  EXPECT_EQ(a.root_position, b.root_position);
  for (std::size_t j = 0; j < a.rotations.size(); ++j)
    EXPECT_EQ(a.rotations[j].coeffs(), b.rotations[j].coeffs());
}

TEST(MotionEnds, AreHeldForWholeFrames) {
  const Clip clip = some_walk();
  const double rate = clip.frames_per_second;
  const MotionEnds ends{.hold_before = 5.2 / rate, .hold_after = 9.9 / rate};
  const Clip held = with_ends(clip, ends).clip;
  ASSERT_EQ(held.frame_count(), 5 + 40 + 10);
  EXPECT_EQ(frames_before(ends, rate), 5);
  for (int f = 0; f < held.frame_count(); ++f)
    expect_same(held.poses[static_cast<std::size_t>(f)],
                clip.poses[static_cast<std::size_t>(std::clamp(f - 5, 0, 39))]);
  EXPECT_FALSE(held.loops);
}

// The last frame is the first of the next cycle, and velocities go on across the seam.
TEST(MotionEnds, OfALoopMeet) {
  const Clip clip = some_walk();
  const AnimatedClip made = with_ends(clip, {.loops = true});
  const Clip& loop = made.clip;
  EXPECT_TRUE(loop.loops);
  ASSERT_EQ(loop.frame_count(), 39);
  const Vec3 way = clip.poses.back().root_position - clip.poses.front().root_position;
  EXPECT_NEAR(loop.cycle_displacement.x(), way.x(), 1e-9);
  EXPECT_NEAR(loop.cycle_displacement.z(), way.z(), 1e-9);
  EXPECT_EQ(loop.cycle_displacement.y(), 0.0);
  const Clip twice = repeated(loop, 2);
  double widest = 0.0, seam = 0.0;
  for (std::size_t f = 1; f < twice.poses.size(); ++f) {
    for (std::size_t j = 0; j < twice.poses[f].rotations.size(); ++j) {
      const double step =
          twice.poses[f - 1].rotations[j].angularDistance(twice.poses[f].rotations[j]);
      (f == 39 ? seam : widest) = std::max(f == 39 ? seam : widest, step);
    }
  }
  EXPECT_LE(seam, widest);
  ASSERT_EQ(made.remarks.size(), 1u);
  EXPECT_NE(made.remarks[0].find("differed by"), std::string::npos);
}

TEST(MotionEnds, TellHowFarAFingerIsFromItsBeginning) {
  Clip clip = some_walk();
  for (Pose& pose : clip.poses) pose.fingers.assign(finger_joint_count, Quat::Identity());
  clip.poses.back().fingers[4] = Quat(Eigen::AngleAxisd(170.0 * radians_per_degree, Vec3::UnitZ()));
  const AnimatedClip made = with_ends(clip, {.loops = true});
  ASSERT_EQ(made.remarks.size(), 1u);
  EXPECT_NE(made.remarks[0].find("differed by 170°"), std::string::npos) << made.remarks[0];
}

TEST(MotionEnds, AreHeldForAFrameAtLeast) {
  const Clip clip = some_walk();
  const Clip held = with_ends(clip, {.hold_after = 0.01 / clip.frames_per_second}).clip;
  EXPECT_EQ(held.frame_count(), clip.frame_count() + 1);
}

TEST(MotionEnds, OfWhatLoopsAreNeitherHeldNorChanged) {
  const Clip loop = with_ends(some_walk(), {.loops = true}).clip;
  ASSERT_TRUE(loop.loops);
  const Clip same = with_ends(loop, {.loops = true}).clip;
  ASSERT_EQ(same.frame_count(), loop.frame_count());
  for (std::size_t f = 0; f < loop.poses.size(); ++f) expect_same(same.poses[f], loop.poses[f]);
  EXPECT_THROW(with_ends(loop, {.hold_before = 0.1}), Error);
  Clip brief = some_walk();
  brief.poses.resize(3);
  EXPECT_THROW(with_ends(brief, {.loops = true}), Error);
  expect_same(with_ends(brief, {}).clip.poses.back(), brief.poses.back());
}

}  // namespace
}  // namespace mien::motion
