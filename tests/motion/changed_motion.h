#pragma once

#include <algorithm>

#include "motion/lint/injected_faults.h"

namespace mien::test {

inline constexpr double degree = radians_per_degree;

/// One cycle of a walk that travels, 30 frames a second.
inline const Clip& changeable_loop() {
  static const Clip loop = builtin_examples("walks-10").examples.front().clip;
  return loop;
}

/// Three cycles of it, which end.
inline Clip changeable_walk() { return three_cycles(changeable_loop()); }

/// A joint turned about an axis of its own frame in every frame, or in those of a stretch.
inline Clip with_turn(Clip clip, BodyJoint joint, const Vec3& axis, double radians, int first = 0,
                      int last = 1 << 30) {
  const Quat turn(Eigen::AngleAxisd(radians, axis.normalized()));
  for (int t = first; t <= std::min(last, clip.frame_count() - 1); ++t)
    clip.poses[t].rotations[joint] = clip.poses[t].rotations[joint] * turn;
  return clip;
}

/// The figure turned about the vertical and set elsewhere.
inline Clip set_elsewhere(Clip clip, const Vec3& shift, double yaw) {
  const Quat turn(Eigen::AngleAxisd(yaw, Vec3::UnitY()));
  for (Pose& pose : clip.poses) {
    pose.root_position = turn * pose.root_position + shift;
    pose.rotations[0] = turn * pose.rotations[0];
  }
  return clip;
}

/// Without its first frames: all comes earlier.
inline Clip without_first(Clip clip, int frames) {
  clip.poses.erase(clip.poses.begin(), clip.poses.begin() + frames);
  return clip;
}

inline Clip without_last(Clip clip, int frames) {
  clip.poses.resize(clip.poses.size() - frames);
  return clip;
}

/// One foot slides evenly by `way` while it stands and comes back in its swing; the leg bends so
/// that nothing else moves.
inline Clip with_sliding_foot(Clip clip, const FootPlant& plant, const Vec3& way) {
  const BodyJoint hip = plant.left ? LeftHip : RightHip;
  const int swing = frames_of(clip, 0.2);
  for (int t = plant.first; t < std::min(plant.last + swing, clip.frame_count()); ++t) {
    const double share = t <= plant.last
                             ? (t - plant.first) / std::max(1.0, 1.0 * plant.last - plant.first)
                             : 1.0 - (t - plant.last) / (1.0 * swing);
    Pose& pose = clip.poses[t];
    const JointTransforms world = world_transforms(clip.body, pose);
    const TwoBoneLimb leg = {world.positions[hip], world.positions[hip + 1],
                             world.positions[hip + 2]};
    const Vec3 knee_forward = world.rotations[Pelvis] * Vec3::UnitZ();
    const TwoBoneSolution bent = solve_two_bone(leg, leg.end + share * way, knee_forward);
    const Quat thigh = bent.upper_turn * world.rotations[hip];
    const Quat shin = bent.lower_turn * world.rotations[hip + 1];
    pose.rotations[hip] = world.rotations[Pelvis].conjugate() * thigh;
    pose.rotations[hip + 1] = thigh.conjugate() * shin;
    pose.rotations[hip + 2] = shin.conjugate() * world.rotations[hip + 2];
  }
  return clip;
}

}  // namespace mien::test
