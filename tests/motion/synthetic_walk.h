#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "motion/math/rotation.h"
#include "motion/skeleton/clip.h"

namespace mien::test {

using namespace mien::motion;

/// A walker whose gait events are known: feet stand still on the floor for `stance` of each stride
/// and move evenly in between; the pelvis follows a path on the floor, straight but for one turn.
/// Phase is distance: at distance k·stride the left foot strikes, at (k + ½)·stride the right.
struct SyntheticWalk {
  double stride = 1.2;      ///< metres
  double stance = 0.6;      ///< share of the stride
  double quickening = 0.0;  ///< share of a swing, at most ½, in which the foot gains or loses speed
  double frames_per_second = 100.0;
  std::vector<double> distance;                                 ///< walked by each frame, metres
  double turn_start = std::numeric_limits<double>::infinity();  ///< metres
  double turn_length = 1.0;                                     ///< metres
  double turn_angle = 0.0;                                      ///< radians to the left
  double heading = 0.0;                                         ///< radians from +Z
};

/// Steady speed, m/s, for some seconds.
inline SyntheticWalk steady_walk(double speed, double seconds, double frames_per_second = 100.0) {
  SyntheticWalk walk;
  walk.frames_per_second = frames_per_second;
  const int frames = static_cast<int>(std::lround(seconds * frames_per_second)) + 1;
  for (int i = 0; i < frames; ++i) walk.distance.push_back(speed * i / frames_per_second);
  return walk;
}

inline double heading_at(const SyntheticWalk& walk, double distance) {
  const double share = std::clamp((distance - walk.turn_start) / walk.turn_length, 0.0, 1.0);
  return walk.heading + (std::isfinite(walk.turn_start) ? share * walk.turn_angle : 0.0);
}

inline Vec3 place_at(const SyntheticWalk& walk, double distance) {
  Vec3 place = Vec3::Zero();
  const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(distance) / 0.01)));
  for (int i = 0; i < steps; ++i) {
    const double yaw = heading_at(walk, distance * (i + 0.5) / steps);
    place += Vec3(std::sin(yaw), 0, std::cos(yaw)) * (distance / steps);
  }
  return place;
}

inline Quat about(const Vec3& axis, double angle) { return Quat(Eigen::AngleAxisd(angle, axis)); }

/// The share of its way that a foot has gone after a share of its swing.
inline double swung(double share, double quickening) {
  const double even = 1.0 / (1.0 - quickening);  // speed in the middle
  const double edge = std::min(share, 1.0 - share);
  const double gone =
      edge < quickening ? 0.5 * even * edge * edge / quickening : even * (edge - 0.5 * quickening);
  return share < 0.5 ? gone : 1.0 - gone;
}

/// Where a foot's ankle is, and how it is turned.
struct SyntheticFoot {
  Vec3 ankle;
  double yaw;
};

inline SyntheticFoot foot_at(const SyntheticWalk& walk, double distance, bool left) {
  const double phase = distance / walk.stride + (left ? 0.0 : 0.5);
  const double step = std::floor(phase);
  const double within = phase - step;
  const auto plant = [&](double k) {
    const double centre = (k + 0.5 * walk.stance - (left ? 0.0 : 0.5)) * walk.stride;
    const double yaw = heading_at(walk, centre);
    const Vec3 side(std::cos(yaw), 0, -std::sin(yaw));
    return SyntheticFoot{place_at(walk, centre) + (left ? 0.09 : -0.09) * side + Vec3(0, 0.08, 0),
                         yaw};
  };
  const SyntheticFoot from = plant(step);
  if (within <= walk.stance) return from;
  const SyntheticFoot to = plant(step + 1);
  const double swing = swung((within - walk.stance) / (1.0 - walk.stance), walk.quickening);
  return {(1 - swing) * from.ankle + swing * to.ankle + Vec3(0, 0.08 * std::sin(pi * swing), 0),
          (1 - swing) * from.yaw + swing * to.yaw};
}

inline void put_leg(Pose& pose, const Skeleton& body, BodyJoint hip, const SyntheticFoot& foot) {
  const Quat pelvis = pose.rotations[Pelvis];
  const Vec3 hip_place = pose.root_position + pelvis * body.joints[hip].offset;
  const Vec3 reach = pelvis.conjugate() * (foot.ankle - hip_place);
  const double thigh = body.joints[hip + 1].offset.norm();
  const double shank = body.joints[hip + 2].offset.norm();
  const double length = std::min(reach.norm(), 0.9999 * (thigh + shank));
  const double forward = std::acos(std::clamp(
      (thigh * thigh + length * length - shank * shank) / (2 * thigh * length), -1.0, 1.0));
  const double backward = std::asin(std::clamp(thigh * std::sin(forward) / shank, -1.0, 1.0));
  const Quat line = turn_between(-Vec3::UnitY(), reach);
  const Quat foot_turn = about(Vec3::UnitY(), foot.yaw);
  pose.rotations[hip] = line * about(Vec3::UnitX(), -forward);
  pose.rotations[hip + 1] = about(Vec3::UnitX(), forward + backward);
  pose.rotations[hip + 2] =
      (pelvis * line * about(Vec3::UnitX(), backward)).conjugate() * foot_turn;
}

inline Pose synthetic_pose(const SyntheticWalk& walk, const Skeleton& body, double distance) {
  Pose pose;
  pose.rotations.assign(body_joint_count, Quat::Identity());
  const double cycle = 2 * pi * distance / walk.stride;
  pose.root_position = place_at(walk, distance) + Vec3(0, 0.86, 0);
  pose.rotations[Pelvis] = about(Vec3::UnitY(), heading_at(walk, distance));
  put_leg(pose, body, LeftHip, foot_at(walk, distance, true));
  put_leg(pose, body, RightHip, foot_at(walk, distance, false));
  // Arms hang, swing against the legs and bend forward.
  const double swing = 0.4 * std::cos(cycle);
  pose.rotations[LeftShoulder] = about(Vec3::UnitX(), swing) * about(Vec3::UnitZ(), -1.45);
  pose.rotations[RightShoulder] = about(Vec3::UnitX(), -swing) * about(Vec3::UnitZ(), 1.45);
  pose.rotations[LeftElbow] = about(Vec3::UnitY(), -0.5 + 0.2 * std::cos(cycle));
  pose.rotations[RightElbow] = about(Vec3::UnitY(), 0.5 + 0.2 * std::cos(cycle));
  return pose;
}

inline Clip synthetic_clip(const SyntheticWalk& walk) {
  Clip clip;
  clip.name = "synthetic";
  clip.body = standard_body();
  clip.frames_per_second = walk.frames_per_second;
  for (const double distance : walk.distance) {
    clip.poses.push_back(synthetic_pose(walk, clip.body, distance));
  }
  return clip;
}

/// Starts from standing, walks straight, turns to the left, walks on and stops.
inline SyntheticWalk long_take() {
  SyntheticWalk walk;
  double distance = 0.0;
  const auto go = [&](double seconds, double from, double to) {
    const int frames = static_cast<int>(seconds * walk.frames_per_second);
    for (int i = 0; i < frames; ++i) {
      walk.distance.push_back(distance);
      distance += (from + (to - from) * i / frames) / walk.frames_per_second;
    }
  };
  go(1.0, 0.0, 0.0);
  go(2.0, 0.0, 1.2);
  go(5.0, 1.2, 1.2);
  walk.turn_start = distance;
  walk.turn_length = 2.4;
  walk.turn_angle = pi / 2;
  go(3.0, 1.2, 1.2);
  go(2.0, 1.2, 0.0);
  go(1.0, 0.0, 0.0);
  return walk;
}

}  // namespace mien::test
