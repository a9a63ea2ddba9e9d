#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "motion/skeleton/sole.h"

#include "injected_faults.h"

// What is wrong with a take as a whole: frozen stretches, poses of a calibration, drift; and walks
// on the spot, which are not wrong.

namespace mien::motion {
namespace {

using namespace mien::test;

double between(std::mt19937_64& random, double least, double most) {
  return std::uniform_real_distribution<double>(least, most)(random);
}

Vec3 level_way(std::mt19937_64& random, double length) {
  const double angle = between(random, 0.0, 2.0 * pi);
  return length * Vec3(std::sin(angle), 0.0, std::cos(angle));
}

/// Goes on at a constant velocity beside what it does.
Clip moved_at(Clip clip, const Vec3& velocity) {
  for (int t = 0; t < clip.frame_count(); ++t)
    clip.poses[t].root_position += t / clip.frames_per_second * velocity;
  return clip;
}

/// Mean velocity of a loop.
Vec3 velocity_of(const Clip& loop) { return loop.cycle_displacement / loop.duration_seconds(); }

TEST(WholeTakes, OfWalksOnTheSpotSkateWithNoFoot) {
  std::mt19937_64 random(1);
  int walks = 0;
  for (const Clip& loop : builtin_walks()) {
    const Vec3 velocity = velocity_of(loop);
    if (velocity.norm() < 0.4) continue;
    ++walks;
    const Clip walk = three_cycles(loop);
    EXPECT_FALSE(find(lint(walk), "on-the-spot")) << loop.name;
    for (const double drift : {0.0, 0.1}) {
      const auto findings = lint(moved_at(walk, level_way(random, drift) - velocity));
      EXPECT_FALSE(find(findings, "foot-skate")) << loop.name << "\n" << all_of(findings);
      EXPECT_FALSE(find(findings, "drift")) << loop.name << "\n" << all_of(findings);
      const Finding* note = find(findings, "on-the-spot");
      ASSERT_TRUE(note) << loop.name << "\n" << all_of(findings);
      EXPECT_NEAR(note->measured, velocity.norm(), 0.05 + drift) << loop.name;
      EXPECT_EQ(note->severity, Severity::warning);
    }
  }
  EXPECT_GT(walks, 20);
}

TEST(WholeTakes, OfWalksOnASpotWhoseFloorWouldJerkSkate) {
  for (const Clip& loop : {builtin_walks()[0], builtin_walks()[3]}) {
    Clip walk = moved_at(three_cycles(loop), -velocity_of(loop));
    for (int t = 0; t < walk.frame_count(); ++t) {
      const double seconds = t / walk.frames_per_second;
      walk.poses[t].root_position.z() += 0.1 * std::sin(2.0 * pi * 1.3 * seconds);
    }
    const auto findings = lint(walk);
    EXPECT_TRUE(find_error(findings, "foot-skate")) << loop.name << "\n" << all_of(findings);
  }
}

/// The frame is shown again so many times.
Clip held(Clip clip, int frame, int times) {
  clip.poses.insert(clip.poses.begin() + frame, times, clip.poses[frame]);
  return clip;
}

TEST(WholeTakes, AreFoundFrozenInTheFramesInWhichTheyAre) {
  std::mt19937_64 random(2);
  for (const Clip& loop : builtin_walks()) {
    const Clip travelling = three_cycles(loop);
    const Clip on_spot = moved_at(travelling, -velocity_of(loop));
    for (const Clip& walk : {travelling, on_spot}) {
      EXPECT_FALSE(find(lint(walk), "frozen")) << loop.name;
      const int first = std::uniform_int_distribution<int>(2, walk.frame_count() - 3)(random);
      const double seconds = between(random, 0.35, 2.0);
      const int times = frames_of(walk, seconds);
      const auto findings = lint(held(walk, first, times));
      const Finding* frozen = find(findings, "frozen");
      ASSERT_TRUE(frozen) << loop.name << "\n" << all_of(findings);
      EXPECT_EQ(frozen->first, first);
      EXPECT_EQ(frozen->last, first + times);
      EXPECT_NEAR(frozen->measured, times / walk.frames_per_second, 1e-9);
      EXPECT_EQ(frozen->severity == Severity::error, frozen->measured > 1.0);
    }
  }
}

TEST(WholeTakes, AreNotFrozenWhereNothingEverMovesOrOneJointDoes) {
  const Clip walk = three_cycles(builtin_walks()[0]);
  Clip still = held(walk, 5, 200);
  still.poses = {still.poses.begin() + 5, still.poses.begin() + 205};
  EXPECT_FALSE(find(lint(still), "frozen"));
  Clip nodding = held(walk, 20, 120);
  for (int t = 20; t <= 140; ++t) {
    Quat& head = nodding.poses[t].rotations[Head];
    head = head * exp(Vec3(0.05 * std::sin(0.3 * t), 0, 0));
  }
  EXPECT_FALSE(find(lint(nodding), "frozen")) << all_of(lint(nodding));
  EXPECT_FALSE(find(lint(held(walk, 20, frames_of(walk, 0.2))), "frozen"));
}

TEST(WholeTakes, ThatWereFrozenBeforeAreNotFoundSoAgain) {
  const Clip walk = held(three_cycles(builtin_walks()[0]), 20, 60);
  const Clip more = held(walk, 20, 200);
  EXPECT_FALSE(find(lint(walk, {}, &walk), "frozen"));
  EXPECT_TRUE(find(lint(more, {}, &walk), "frozen"));
}

/// The body's own rest pose, arms stretched out, where the motion starts.
Pose arms_stretched_out(const Clip& clip) {
  Pose pose = clip.poses.front();
  for (Quat& rotation : pose.rotations) rotation = Quat::Identity();
  return pose;
}

// All else is judged as if the pose had never been there.
TEST(WholeTakes, ThatBeginWithAPoseOfCalibrationAreJudgedWithoutIt) {
  std::vector<Clip> takes;
  for (const Clip& loop : builtin_walks()) takes.push_back(three_cycles(loop));
  bend_knee_backwards(takes[0], true, 20, 32, 35.0);
  leap(takes[1], Head, 15, 40.0, Vec3::UnitX());
  for (const Clip& take : takes) {
    const auto plain = lint(take);
    EXPECT_FALSE(find(plain, "calibration-pose")) << take.name;
    EXPECT_FALSE(calibration_pose(take)) << take.name;
    for (const int frames : {1, 2, frames_of(take, 1.0)}) {
      Clip with = take;
      with.poses.insert(with.poses.begin(), frames, arms_stretched_out(take));
      auto findings = lint(with);
      const Finding* found = find(findings, "calibration-pose");
      ASSERT_TRUE(found) << take.name << " " << frames << "\n" << all_of(findings);
      EXPECT_EQ(found->first, 0);
      EXPECT_EQ(found->last, frames - 1);
      EXPECT_EQ(found->severity, Severity::error);
      EXPECT_EQ(calibration_pose(with).value().last, frames - 1);
      std::erase_if(findings, [](const Finding& one) { return one.check == "calibration-pose"; });
      ASSERT_EQ(findings.size(), plain.size()) << take.name << "\n" << all_of(findings);
      for (size_t i = 0; i < plain.size(); ++i) {
        EXPECT_EQ(findings[i].check, plain[i].check);
        EXPECT_EQ(findings[i].first, plain[i].first + frames);
        EXPECT_EQ(findings[i].last, plain[i].last + frames);
        EXPECT_EQ(findings[i].measured, plain[i].measured);
      }
    }
  }
}

// A fault of one joint at the start is not taken for a pose of the whole body.
TEST(WholeTakes, InWhichOneJointLeapsAtTheStartHaveNoPoseOfCalibration) {
  Clip take = three_cycles(builtin_walks()[0]);
  take.poses[0].rotations[LeftElbow] = take.poses[0].rotations[LeftElbow] * exp(Vec3(0, 0, 1.5));
  const auto findings = lint(take);
  EXPECT_FALSE(find(findings, "calibration-pose")) << all_of(findings);
  EXPECT_TRUE(find_error(findings, "jump", "", 0, 1)) << all_of(findings);
}

TEST(WholeTakes, ThatLeapLaterHaveNoPoseOfCalibration) {
  const Clip walk = three_cycles(builtin_walks()[0]);
  Clip torn = walk;
  torn.poses.insert(torn.poses.begin() + 30, arms_stretched_out(walk));
  const auto findings = lint(torn);
  EXPECT_FALSE(find(findings, "calibration-pose"));
  EXPECT_TRUE(find_error(findings, "jump", "", 29, 32)) << all_of(findings);
}

/// Stands at ease for some seconds and breathes.
Clip standing(double seconds) {
  Clip clip;
  clip.body = standard_body();
  clip.frames_per_second = 60.0;
  for (int t = 0; t < seconds * clip.frames_per_second; ++t) {
    Pose pose;
    pose.rotations.assign(body_joint_count, Quat::Identity());
    pose.root_position = Vec3(0, 0.96, 0);
    pose.rotations[Chest] = exp(Vec3(0.02 * std::sin(0.025 * t), 0, 0));
    pose.rotations[LeftShoulder] = exp(Vec3(0, 0, -1.4));
    pose.rotations[RightShoulder] = exp(Vec3(0, 0, 1.4));
    clip.poses.push_back(pose);
  }
  return clip;
}

/// A pose near the motion's own but for one arm, as of somebody who stands ready: one joint leaps.
Pose pose_of_readiness(const Clip& clip) {
  Pose pose = clip.poses.front();
  for (Quat& rotation : pose.rotations) rotation = rotation * exp(Vec3(0.08, 0.05, -0.06));
  pose.rotations[LeftElbow] = pose.rotations[LeftElbow] * exp(Vec3(0, 0, 1.5));
  return pose;
}

TEST(WholeTakes, MayBeginWithAPoseOutOfWhichFewJointsLeapButAllStep) {
  Clip take = standing(3.0);
  take.poses.insert(take.poses.begin(), pose_of_readiness(take));
  const auto findings = lint(take);
  const Finding* found = find(findings, "calibration-pose");
  ASSERT_TRUE(found) << all_of(findings);
  EXPECT_EQ(found->last, 0);
  EXPECT_EQ(found->measured, 1.0);
  EXPECT_FALSE(find(findings, "jump")) << all_of(findings);
}

TEST(WholeTakes, OfBodiesThatSlideOnBothFeetDriftAndDoNotSkate) {
  std::mt19937_64 random(3);
  EXPECT_TRUE(lint(standing(5.0)).empty()) << all_of(lint(standing(5.0)));
  for (int round = 0; round < 20; ++round) {
    const double speed = between(random, 0.02, 0.12);
    const auto findings = lint(moved_at(standing(5.0), level_way(random, speed)));
    const Finding* drift = find(findings, "drift");
    ASSERT_TRUE(drift) << speed << "\n" << all_of(findings);
    EXPECT_NEAR(drift->measured, 5.0 * speed, 0.1 * 5.0 * speed);
    EXPECT_LE(drift->first, 3);
    EXPECT_GE(drift->last, 296);
    EXPECT_FALSE(find(findings, "foot-skate")) << all_of(findings);
  }
}

TEST(WholeTakes, OfBodiesThatSlideToAndFroSkate) {
  Clip clip = standing(5.0);
  for (int t = 0; t < clip.frame_count(); ++t)
    clip.poses[t].root_position.x() += 0.04 * std::sin(0.04 * t);
  const auto findings = lint(clip);
  EXPECT_FALSE(find(findings, "drift")) << all_of(findings);
  EXPECT_TRUE(find(findings, "foot-skate")) << all_of(findings);
}

TEST(WholeTakes, ThatRiseOrSinkSteadilyDrift) {
  std::mt19937_64 random(4);
  for (const Clip& loop : builtin_walks()) {
    const Clip walk = three_cycles(loop);
    EXPECT_FALSE(find(lint(walk), "drift")) << loop.name << "\n" << all_of(lint(walk));
    const double rise = between(random, 0.12, 0.3) * (random() % 2 == 0 ? 1.0 : -1.0);
    const double seconds = (walk.frame_count() - 1) / walk.frames_per_second;
    const auto findings = lint(moved_at(walk, Vec3(0.0, rise / seconds, 0.0)));
    const Finding* drift = find_error(findings, "drift");
    ASSERT_TRUE(drift) << loop.name << " " << rise << "\n" << all_of(findings);
    EXPECT_NEAR(drift->measured, std::abs(rise), 0.2 * std::abs(rise)) << loop.name;
    EXPECT_NE(drift->sentence.find(rise > 0.0 ? "rises" : "sinks"), std::string::npos);
  }
}

/// Every step stands higher by so many metres than the one before, and is climbed within 0.15 s
/// from when the other foot has become the lower one by a millimetre.
Clip upstairs(Clip walk, double step) {
  const auto lowest = [](const SolePoints& sole) {
    return std::min({sole.heel.y(), sole.ball.y(), sole.tip.y()});
  };
  const auto left = sole_paths(walk, true);
  const auto right = sole_paths(walk, false);
  bool on_left = lowest(left[0]) < lowest(right[0]);
  double wanted = 0.0, height = 0.0;
  for (int t = 0; t < walk.frame_count(); ++t) {
    const double lower = lowest(left[t]) - lowest(right[t]);
    if (on_left ? lower > 0.001 : lower < -0.001) {
      on_left = !on_left;
      wanted += step;
    }
    height = std::min(wanted, height + step / (0.15 * walk.frames_per_second));
    walk.poses[t].root_position.y() += height;
  }
  EXPECT_GT(height, 4.0 * step) << walk.name;
  return walk;
}

TEST(WholeTakes, ThatGoUpstairsDoNotDrift) {
  for (const Clip& loop : builtin_walks()) {
    const auto findings = lint(upstairs(three_cycles(loop), 0.17));
    EXPECT_FALSE(find(findings, "drift")) << loop.name << "\n" << all_of(findings);
  }
}

}  // namespace
}  // namespace mien::motion
