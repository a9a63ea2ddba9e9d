#include "motion/gait/loop.h"

#include <random>

#include <gtest/gtest.h>

#include "motion/skeleton/mirror.h"
#include "motion/synthetic_walk.h"

namespace mien::motion {
namespace {

using namespace mien::test;

/// A clip of smooth random joint angles that wanders about.
Clip wandering(unsigned seed, int frames) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto draw = [&] {
    const double x = uniform(random);
    const double y = uniform(random);
    return Vec3(x, y, uniform(random));
  };
  std::array<std::array<Vec3, 3>, body_joint_count + 1> waves;
  for (auto& wave : waves) {
    for (Vec3& part : wave) part = draw();
  }
  Clip clip;
  clip.body = standard_body();
  clip.frames_per_second = 60.0;
  for (int i = 0; i < frames; ++i) {
    const double t = i / 60.0;
    const auto value = [&](size_t j) -> Vec3 {
      return waves[j][0] * std::sin(1.3 * t) + waves[j][1] * std::cos(2.1 * t) +
             0.3 * t * waves[j][2];
    };
    Pose pose;
    pose.root_position = value(body_joint_count) + Vec3(0, 1, 0);
    for (size_t j = 0; j < body_joint_count; ++j) {
      pose.rotations.push_back(mien::motion::exp(0.5 * value(j)));
    }
    clip.poses.push_back(pose);
  }
  return clip;
}

/// The frame after the last, as the loop has it: its first, displaced.
Pose next_first(const Clip& loop) {
  Pose pose = loop.poses.front();
  pose.root_position += loop.cycle_displacement;
  return pose;
}

TEST(Loop, HasNoJumpAtItsSeam) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Clip clip = wandering(seed, 120);
    const Clip loop = closed_loop(clip, 10, 90);
    ASSERT_EQ(loop.frame_count(), 80);
    // What the closing makes of frame 90 is frame 0 again: extrapolated speeds agree across it.
    const Pose next = next_first(loop);
    for (int j = 0; j < body_joint_count; ++j) {
      const Vec3 before = log(next.rotations[j] * loop.poses[79].rotations[j].conjugate());
      const Vec3 earlier =
          log(loop.poses[79].rotations[j] * loop.poses[78].rotations[j].conjugate());
      const Vec3 after = log(loop.poses[1].rotations[j] * loop.poses[0].rotations[j].conjugate());
      // Speeds per frame differ by no more than accelerations make them differ elsewhere.
      EXPECT_LT((before - after).norm(), 0.02) << seed << " " << j;
      EXPECT_LT((before - earlier).norm(), 0.02) << seed << " " << j;
    }
  }
}

TEST(Loop, EndsExactlyWhereItStarts) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Clip clip = wandering(seed, 100);
    const Clip closed = closed_ends(clip, 7, 88);
    const Clip loop = closed_loop(clip, 7, 88);
    const Pose next = next_first(loop);
    const Pose& last = closed.poses.back();
    EXPECT_LT((next.root_position - last.root_position).norm(), 1e-12);
    for (int j = 0; j < body_joint_count; ++j) {
      EXPECT_LT(angle_between(next.rotations[j], last.rotations[j]), 1e-12) << seed << " " << j;
    }
  }
}

TEST(Loop, KeepsItsWayForward) {
  const Clip clip = synthetic_clip(steady_walk(1.2, 3.0));
  const Clip loop = closed_loop(clip, 100, 200);
  EXPECT_NEAR((loop.cycle_displacement - Vec3(0, 0, 1.2)).norm(), 0.0, 1e-9);
  EXPECT_TRUE(loop.loops);
}

TEST(Loop, OfAPeriodicMotionIsThatMotion) {
  const Clip clip = synthetic_clip(steady_walk(1.2, 3.0));
  const Clip loop = closed_loop(clip, 100, 200);
  for (int i = 0; i < 100; ++i) {
    EXPECT_NEAR((loop.poses[i].root_position - clip.poses[100 + i].root_position).norm(), 0, 1e-9);
    for (int j = 0; j < body_joint_count; ++j) {
      EXPECT_LT(angle_between(loop.poses[i].rotations[j], clip.poses[100 + i].rotations[j]), 1e-6);
    }
  }
}

TEST(ShiftedLoop, IsTheSameMotionForEver) {
  const Clip loop = closed_loop(wandering(3, 100), 0, 80);
  for (const int shift : {0, 13, 80, 95, -7}) {
    const Clip shifted = shifted_loop(loop, shift);
    for (const double seconds : {-0.7, 0.0, 0.31, 1.9}) {
      const Pose a = pose_at(loop, seconds + shift / 60.0);
      const Pose b = pose_at(shifted, seconds);
      EXPECT_NEAR((a.root_position - b.root_position).norm(), 0.0, 1e-9) << shift;
      EXPECT_LT(angle_between(a.rotations[LeftKnee], b.rotations[LeftKnee]), 1e-7) << shift;
    }
  }
}

TEST(MirroredLoop, RepeatsItsFirstHalfInTheMirror) {
  const Clip clip = wandering(9, 60);
  const Clip loop = mirrored_loop(clip, 5, 45);
  ASSERT_EQ(loop.frame_count(), 80);
  const Vec3 half = 0.5 * loop.cycle_displacement;
  for (int i = 0; i < 40; ++i) {
    const Pose image = mirrored(loop.poses[i]);
    EXPECT_NEAR((image.root_position + half - loop.poses[40 + i].root_position).norm(), 0, 1e-9);
    for (int j = 0; j < body_joint_count; ++j) {
      EXPECT_LT(angle_between(image.rotations[j], loop.poses[40 + i].rotations[j]), 1e-7);
    }
  }
  EXPECT_DOUBLE_EQ(loop.cycle_displacement.x(), 0.0);
}

TEST(MirroredLoop, OfAnEvenWalkIsThatWalk) {
  const Clip clip = synthetic_clip(steady_walk(1.2, 3.0));
  const Clip loop = mirrored_loop(clip, 100, 150);
  const Clip whole = closed_loop(clip, 100, 200);
  EXPECT_NEAR((loop.cycle_displacement - whole.cycle_displacement).norm(), 0.0, 1e-6);
  for (int i = 0; i < 100; i += 7) {
    const auto a = world_positions(loop.body, loop.poses[i]);
    const auto b = world_positions(whole.body, whole.poses[i]);
    EXPECT_NEAR((a[LeftAnkle] - b[LeftAnkle]).norm(), 0.0, 0.02) << i;
    EXPECT_NEAR((a[RightWrist] - b[RightWrist]).norm(), 0.0, 0.02) << i;
  }
}

}  // namespace
}  // namespace mien::motion
