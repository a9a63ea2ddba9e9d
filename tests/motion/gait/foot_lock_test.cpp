#include "motion/gait/foot_lock.h"

#include <cmath>

#include <gtest/gtest.h>

#include "motion/gait/foot_path.h"
#include "motion/math/rotation.h"
#include "motion/skeleton/two_bone_ik.h"

namespace mien::motion {
namespace {

constexpr int cycle_frames = 60;
constexpr double fps = 60.0;
constexpr double stride_m = 1.1;

/// A foot that stands still from phase 0 to 0.6 and swings forward until 1. `slip` metres per cycle
/// of backward slip is what a bad blend looks like.
Vec3 ankle_at(double phase, double lateral, double slip) {
  const double cycle = std::floor(phase);
  const double p = phase - cycle;
  const double start = cycle * stride_m;
  if (p < 0.6) return {lateral, 0.08, start - slip * p};
  const double s = (p - 0.6) / 0.4;
  const double ease = s * s * (3.0 - 2.0 * s);
  return {lateral, 0.08 + 0.12 * std::sin(pi * s) * std::sin(pi * s),
          start - slip * 0.6 + ease * (stride_m + slip * 0.6)};
}

void place_leg(Pose& pose, const Skeleton& body, bool left, const Vec3& ankle) {
  const LegJoints leg = leg_joints(left);
  const JointTransforms world = world_transforms(body, pose);
  const TwoBoneSolution solution = solve_two_bone(
      {world.positions[leg.hip], world.positions[leg.knee], world.positions[leg.ankle]}, ankle,
      Vec3::UnitZ());
  pose.rotations[leg.hip] = solution.upper_turn;
  const Quat shank = solution.lower_turn;
  pose.rotations[leg.knee] = solution.upper_turn.conjugate() * shank;
  pose.rotations[leg.ankle] = shank.conjugate();
}

/// The right foot hangs `right_hang` metres too high.
Clip slipping_walk(double slip, double right_hang = 0.0) {
  Clip clip;
  clip.body = standard_body();
  clip.frames_per_second = fps;
  clip.loops = true;
  clip.cycle_displacement = Vec3(0, 0, stride_m);
  for (int f = 0; f < cycle_frames; ++f) {
    const double phase = double(f) / cycle_frames;
    Pose pose;
    pose.rotations.assign(body_joint_count, Quat::Identity());
    pose.root_position = Vec3(0, 0.87, stride_m * (phase - 0.3));
    place_leg(pose, clip.body, true, ankle_at(phase, 0.09, slip));
    place_leg(pose, clip.body, false,
              ankle_at(phase - 0.5, -0.09, slip) + Vec3(0, right_hang, stride_m / 2));
    clip.poses.push_back(pose);
  }
  return clip;
}

const std::vector<FootPlant> plants = {{true, 0, 35}, {false, 30, 65}};

TEST(FootLock, HoldsPlantedFeetStill) {
  for (double slip : {0.02, 0.05, -0.04}) {
    const Clip clip = slipping_walk(slip);
    EXPECT_GT(planted_drift(clip, plants), 0.01);
    EXPECT_LT(planted_drift(foot_locked(clip, plants), plants), 1e-6) << slip;
  }
}

TEST(FootLock, BringsFeetThatHangDownToTheFloor) {
  const Clip expected = foot_locked(slipping_walk(0.0), plants);
  Clip lifted = slipping_walk(0.0, 0.03);
  for (Pose& pose : lifted.poses) pose.root_position.y() += 0.05;
  const Clip locked = foot_locked(lifted, plants);
  for (size_t f = 0; f < locked.poses.size(); ++f) {
    const auto found = world_positions(locked.body, locked.poses[f]);
    const auto wanted = world_positions(expected.body, expected.poses[f]);
    for (const BodyJoint ankle : {LeftAnkle, RightAnkle}) {
      EXPECT_LT((found[ankle] - wanted[ankle]).norm(), 1e-6) << f;
    }
    // Half of what only one foot hangs is taken from the whole figure.
    EXPECT_LT(std::abs(found[Pelvis].y() - wanted[Pelvis].y()), 0.0151) << f;
  }
}

TEST(FootLock, BringsTheToesOfAStandingFootDown) {
  Clip clip = slipping_walk(0.02);
  const Quat toes_up(Eigen::AngleAxisd(-10.0 * radians_per_degree, Vec3::UnitX()));
  for (Pose& pose : clip.poses) pose.rotations[RightAnkle] = pose.rotations[RightAnkle] * toes_up;
  const Clip locked = foot_locked(clip, plants);
  const auto ball = [](const Clip& of, size_t frame) {
    return world_positions(of.body, of.poses[frame])[RightToe].y();
  };
  EXPECT_NEAR(ball(locked, 48), ball(slipping_walk(0.0), 48), 1e-3);
  EXPECT_GT(ball(clip, 48), ball(locked, 48) + 0.02);
}

TEST(Stance, OfAFootThatTiltsAllTheWhileIsFlatWhereItIsLevelest) {
  FootPath path;
  path.ball_in_foot = Vec3(0, -0.07, 0.15);
  path.heel_in_foot = Vec3(0, -0.07, -0.05);
  constexpr int count = 21;
  for (int f = 0; f < count; ++f) {
    path.ankle.emplace_back(0, 0.09, 0);
    const double toes_down = (f - count / 2) * radians_per_degree * 1.5;
    path.rotation.emplace_back(Eigen::AngleAxisd(toes_down, Vec3::UnitX()));
  }
  const Stance stance = stance_of(path, {true, 0, count - 1}, 0.006, 0.015);
  // The ball falls and the heel rises from first to last: at the end the foot stands on its toes.
  EXPECT_GT(stance.flat_first, 3);
  EXPECT_LT(stance.flat_last, count - 4);
}

TEST(FootLock, LeavesFeetThatStandStillAlone) {
  const Clip clip = slipping_walk(0.0);
  const Clip locked = foot_locked(clip, plants);
  for (size_t f = 0; f < clip.poses.size(); ++f) {
    const auto before = world_positions(clip.body, clip.poses[f]);
    const auto after = world_positions(locked.body, locked.poses[f]);
    for (size_t j = 0; j < before.size(); ++j) EXPECT_LT((before[j] - after[j]).norm(), 1e-6);
  }
}

TEST(FootLock, KeepsBoneLengthsAndTheUpperBody) {
  const Clip clip = slipping_walk(0.05);
  const Clip locked = foot_locked(clip, plants);
  for (size_t f = 0; f < clip.poses.size(); ++f) {
    for (int j = Spine; j <= RightWrist; ++j) {
      EXPECT_LT(angle_between(clip.poses[f].rotations[j], locked.poses[f].rotations[j]), 1e-12);
    }
    const auto positions = world_positions(locked.body, locked.poses[f]);
    for (size_t j = 1; j < positions.size(); ++j) {
      EXPECT_NEAR((positions[j] - positions[static_cast<size_t>(body_parents[j])]).norm(),
                  locked.body.joints[j].offset.norm(), 1e-12);
    }
  }
}

TEST(FootLock, NothingPops) {
  const Clip clip = slipping_walk(0.05);
  const Clip locked = foot_locked(clip, plants);
  const auto largest_step = [](const Clip& c) {
    double largest = 0.0;
    for (int f = 0; f < c.frame_count(); ++f) {
      const auto now = world_positions(c.body, pose_at(c, f / fps));
      const auto next = world_positions(c.body, pose_at(c, (f + 1) / fps));
      for (size_t j = 0; j < now.size(); ++j) {
        largest = std::max(largest, (next[j] - now[j]).norm());
      }
    }
    return largest;
  };
  EXPECT_LT(largest_step(locked), 1.15 * largest_step(clip));
}

TEST(FootLock, SinksThePelvisWhereALegWouldHaveToStretch) {
  Clip clip = slipping_walk(0.05);
  for (Pose& pose : clip.poses) pose.root_position.y() += 0.06;
  for (int f = 0; f < cycle_frames; ++f) {
    const double phase = double(f) / cycle_frames;
    place_leg(clip.poses[f], clip.body, true, ankle_at(phase, 0.09, 0.05));
    place_leg(clip.poses[f], clip.body, false,
              ankle_at(phase - 0.5, -0.09, 0.05) + Vec3(0, 0, stride_m / 2));
  }
  const Clip locked = foot_locked(clip, plants);
  EXPECT_LT(planted_drift(locked, plants), 1e-4);
  double sunk = 0.0;
  for (int f = 0; f < cycle_frames; ++f) {
    sunk = std::max(sunk, clip.poses[f].root_position.y() - locked.poses[f].root_position.y());
  }
  EXPECT_GT(sunk, 0.001);
  EXPECT_LT(sunk, 0.10);
}

}  // namespace
}  // namespace mien::motion
