#include "motion/measures/distance/distance.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "motion/math/rotation.h"

namespace mien::motion {
namespace {

constexpr std::array<Alignment, 2> both_alignments = {Alignment::pelvis, Alignment::world};

Pose standing() {
  Pose pose;
  pose.root_position = Vec3(0, 0.97, 0);
  pose.rotations.assign(body_joint_count, Quat::Identity());
  return pose;
}

Example example_of(std::vector<Pose> poses, double frames_per_second, bool loops) {
  Example example;
  example.clip.body = standard_body();
  example.clip.frames_per_second = frames_per_second;
  example.clip.poses = std::move(poses);
  example.clip.loops = loops;
  example.keytimes = {0.0, example.clip.duration_seconds()};
  return example;
}

Example held(const Pose& pose) { return example_of(std::vector<Pose>(31, pose), 30.0, false); }

/// A loop in place of smooth random joint angles, `frames` frames in one second. The same seed is
/// the same motion at any number of frames.
Example dance(unsigned seed, int frames, double phase_shift = 0.0) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(-0.6, 0.6);
  std::vector<Vec3> amplitudes(body_joint_count);
  std::vector<double> phases(body_joint_count);
  for (auto& a : amplitudes) a = Vec3(uniform(random), uniform(random), uniform(random));
  for (auto& p : phases) p = 5.0 * uniform(random);
  std::vector<Pose> poses;
  for (int i = 0; i < frames; ++i) {
    const double cycle = 2 * pi * (static_cast<double>(i) / frames + phase_shift);
    Pose pose = standing();
    pose.root_position += Vec3(0.05 * std::sin(cycle), 0.02 * std::cos(2 * cycle), 0);
    for (size_t j = 0; j < body_joint_count; ++j) {
      pose.rotations[j] = exp(amplitudes[j] * std::sin(cycle + phases[j]));
    }
    poses.push_back(pose);
  }
  return example_of(poses, frames, true);
}

Example moved(Example example, const Vec3& offset, double yaw) {
  const Quat turn(Eigen::AngleAxisd(yaw, Vec3::UnitY()));
  for (Pose& pose : example.clip.poses) {
    pose.root_position = turn * pose.root_position + offset;
    pose.rotations[0] = turn * pose.rotations[0];
  }
  example.clip.cycle_displacement = turn * example.clip.cycle_displacement;
  return example;
}

TEST(Distance, OfAMotionToItselfIsZero) {
  for (const Alignment alignment : both_alignments) {
    const Distance d = distance(dance(1, 40), dance(1, 40), alignment);
    EXPECT_EQ(d.mean, 0.0);
    EXPECT_EQ(d.mpjpe, 0.0);
    EXPECT_TRUE(d.matches());
  }
}

TEST(Distance, OfARaisedBodyIsTheRise) {
  for (const Alignment alignment : both_alignments) {
    const Distance d = distance(dance(2, 40), moved(dance(2, 40), {0, 0.1, 0}, 0), alignment);
    EXPECT_NEAR(d.mean, 0.1, 1e-12);
    EXPECT_NEAR(d.sum, 0.1 * 220, 1e-10);
    EXPECT_NEAR(d.mpjpe, 0.1, 1e-12);
    EXPECT_FALSE(d.matches());
    for (const double joint : d.by_joint()) EXPECT_NEAR(joint, 0.1, 1e-12);
    for (const double time : d.by_time()) EXPECT_NEAR(time, 0.1, 1e-12);
  }
}

TEST(Distance, DoesNotSeePlaceOnTheFloorNorHeading) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(-3, 3);
  for (int i = 0; i < 20; ++i) {
    const Vec3 offset(uniform(random), 0, uniform(random));
    const Example other = moved(dance(4, 30), offset, uniform(random));
    for (const Alignment alignment : both_alignments) {
      EXPECT_LT(distance(dance(4, 30), other, alignment).mean, 1e-12);
    }
  }
}

TEST(Distance, OfOneBentElbowIsTheChordOfTheWrist) {
  Pose bent = standing();
  const double angle = 0.7;
  bent.rotations[LeftElbow] = exp(Vec3(0, 0, angle));
  const Distance d = distance(held(standing()), held(bent));
  const double forearm = standard_body().joints[LeftWrist].offset.norm();
  const double chord = 2 * forearm * std::sin(angle / 2);
  for (int j = 1; j < body_joint_count; ++j) {
    const double expected = j == LeftWrist ? chord : 0.0;
    EXPECT_NEAR(d.by_joint()[static_cast<size_t>(j - 1)], expected, 1e-12) << j;
  }
  EXPECT_NEAR(d.mean, chord / 20, 1e-12);
  EXPECT_NEAR(d.mpjpe, chord / 20, 1e-12);
}

TEST(Distance, OfAChangingPoseIsSampledAtElevenTimes) {
  std::vector<Pose> rising(31, standing());
  for (size_t i = 0; i < rising.size(); ++i) {
    rising[i].root_position.y() += static_cast<double>(i) * 0.01;
  }
  const Distance d = distance(held(standing()), example_of(rising, 30.0, false));
  for (int t = 0; t < distance_times; ++t) {
    EXPECT_NEAR(d.by_time()[static_cast<size_t>(t)], 0.03 * t, 1e-12);
    EXPECT_NEAR(d.by_joint_and_time(Head - 1, t), 0.03 * t, 1e-12);
  }
}

TEST(Distance, ComparesAtTheSameShareOfBothDurations) {
  // The same performance at half the speed: every frame of the fast one is a frame of the slow one.
  const Example fast = dance(5, 30);
  Example slow = fast;
  slow.clip.frames_per_second /= 2;
  slow.keytimes.back() *= 2;
  EXPECT_LT(distance(fast, slow).mean, 1e-12);
  EXPECT_LT(distance(slow, fast).mpjpe, 1e-12);
}

/// `motion`, its first `share` played in `new_share` of the time, as the keytimes say.
Example warped(const Example& motion, double share, double new_share, int frames) {
  const double duration = motion.clip.duration_seconds();
  Example result = motion;
  result.clip.frames_per_second = frames / duration;
  result.clip.poses.clear();
  for (int i = 0; i < frames; ++i) {
    const double t = static_cast<double>(i) / frames;
    const double source = t < new_share ? t / new_share * share
                                        : share + (t - new_share) / (1 - new_share) * (1 - share);
    result.clip.poses.push_back(pose_at(motion.clip, source * duration));
  }
  result.keytimes = {0.0, new_share * duration, duration};
  return result;
}

TEST(Distance, OfATimeWarpedCopyVanishesWhenKeytimesTellTheWarp) {
  Example motion = dance(6, 200);
  motion.keytimes = {0.0, 0.5, 1.0};
  const Example copy = warped(motion, 0.5, 0.3, 1000);
  EXPECT_LT(distance(motion, copy).mean, 2e-3);
  EXPECT_LT(distance(copy, motion).mean, 2e-3);
  Example unmarked = copy;
  unmarked.keytimes = {0.0, 1.0};
  EXPECT_GT(distance(motion, unmarked).mean, 0.02);
}

TEST(Distance, IsSymmetricWhenKeytimesAgree) {
  for (unsigned seed = 0; seed < 10; ++seed) {
    const Example a = dance(seed, 40);
    const Example b = dance(seed + 100, 40);
    for (const Alignment alignment : both_alignments) {
      EXPECT_NEAR(distance(a, b, alignment).mean, distance(b, a, alignment).mean, 1e-12);
    }
  }
}

TEST(Distance, IsSymmetricWhateverTheKeytimes) {
  for (unsigned seed = 0; seed < 10; ++seed) {
    Example a = dance(seed, 40);
    Example b = dance(seed + 100, 55);
    a.keytimes = {0.0, 0.2, 0.5, 0.7, a.keytimes.back()};
    b.keytimes = {0.0, 0.3, 0.35, 0.8, b.keytimes.back()};
    for (const Alignment alignment : both_alignments) {
      EXPECT_NEAR(distance(a, b, alignment).mean, distance(b, a, alignment).mean, 1e-12);
    }
  }
}

TEST(Distance, ObeysTheTriangleInequality) {
  for (unsigned seed = 0; seed < 10; ++seed) {
    const Example a = dance(seed, 40);
    const Example b = dance(seed + 100, 40);
    const Example c = dance(seed + 200, 40);
    EXPECT_LE(distance(a, c).mean, distance(a, b).mean + distance(b, c).mean + 1e-12);
  }
}

TEST(Distance, OfALoopInPlaceIsTheSameAtBothEnds) {
  const Distance d = distance(dance(7, 33), dance(8, 47));
  EXPECT_GT(d.mean, 0.01);
  for (int j = 0; j < distance_joints; ++j) {
    EXPECT_NEAR(d.by_joint_and_time(j, 0), d.by_joint_and_time(j, distance_times - 1), 1e-12);
  }
}

Example travelling(double metres) {
  Example example = example_of(std::vector<Pose>(30, standing()), 30.0, true);
  example.clip.cycle_displacement = Vec3(0, 0, metres);
  for (size_t i = 0; i < 30; ++i) {
    example.clip.poses[i].root_position.z() = metres * static_cast<double>(i) / 30.0;
  }
  return example;
}

TEST(Distance, SeesTravelOnlyInTheWorld) {
  EXPECT_LT(distance(travelling(1.2), travelling(1.4)).mean, 1e-12);
  const Distance d = distance(travelling(1.2), travelling(1.4), Alignment::world);
  for (int t = 0; t < distance_times; ++t) {
    EXPECT_NEAR(d.by_time()[static_cast<size_t>(t)], 0.02 * t, 1e-12);
  }
}

TEST(Distance, SeesTurningOnlyInTheWorld) {
  Example turning = held(standing());
  for (size_t i = 0; i < 31; ++i) {
    turning.clip.poses[i].rotations[0] = exp(Vec3(0, 0.05 * static_cast<double>(i), 0));
  }
  EXPECT_LT(distance(held(standing()), turning).mean, 1e-12);
  const Distance d = distance(held(standing()), turning, Alignment::world);
  EXPECT_LT(d.by_time().front(), 1e-12);
  EXPECT_GT(d.by_time().back(), 0.1);
}

TEST(Distance, MpjpeIsTheMeanOverTheTargetsFrames) {
  std::vector<Pose> jump(4, standing());
  jump[2].root_position.y() += 0.4;
  const Distance d = distance(example_of(jump, 30.0, false),
                              example_of(std::vector<Pose>(4, standing()), 30.0, false));
  EXPECT_NEAR(d.mpjpe, 0.1, 1e-12);
}

TEST(Distance, OfSingleFramesIsThatOfThePoses) {
  Pose raised = standing();
  raised.root_position.y() += 0.05;
  const Distance d =
      distance(example_of({standing()}, 30.0, false), example_of({raised}, 30.0, false));
  EXPECT_NEAR(d.mean, 0.05, 1e-12);
  EXPECT_NEAR(d.mpjpe, 0.05, 1e-12);
}

TEST(Distance, OfAStillFromAMotionIsANumber) {
  Example still = example_of({standing()}, 30.0, false);
  still.keytimes = {0.0, 0.0};
  Example motion = dance(3, 40);
  motion.keytimes = {0.0, motion.clip.duration_seconds()};
  EXPECT_GT(distance(motion, still).mean, 0.0);
  EXPECT_TRUE(std::isfinite(distance(still, motion).mpjpe));
}

TEST(Distance, CorrespondingTimeIsExactAtKeytimes) {
  Example a = dance(9, 30);
  Example b = dance(9, 30);
  a.keytimes = {0.0, 0.2, 0.5, 1.0};
  b.keytimes = {0.0, 0.4, 0.6, 1.0};
  for (size_t k = 0; k < a.keytimes.size(); ++k) {
    EXPECT_NEAR(corresponding_time(a, b, a.keytimes[k]), b.keytimes[k], 1e-12);
  }
  EXPECT_NEAR(corresponding_time(a, b, 0.35), 0.5, 1e-12);
  EXPECT_NEAR(corresponding_time(a, a, 0.35), 0.35, 1e-12);
}

}  // namespace
}  // namespace mien::motion
