#pragma once

#include <array>
#include <random>

#include "motion/math/rotation.h"
#include "motion/skeleton/clip.h"
#include "motion/skeleton/recording.h"

namespace mien::test {

using namespace mien::motion;

/// Constant turns between the canonical joint frames and those of another rig.
using FrameTurns = std::array<Quat, body_joint_count>;

/// Every bone along its joint's ±X, as the Bandai-Namco rig has it: left and right mirrored, and
/// the zero pose a straight line of bones.
inline FrameTurns bones_along_x() {
  FrameTurns turns;
  for (int j = 0; j < body_joint_count; ++j) {
    const auto joint = BodyJoint(j);
    const Vec3 bone = (is_right(joint) ? -1.0 : 1.0) * Vec3::UnitX();
    turns[j] = turn_between(bone, rest_direction(joint));
  }
  return turns;
}

inline FrameTurns random_turns(unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  FrameTurns turns;
  for (Quat& turn : turns) {
    const double w = normal(random);
    const double x = normal(random);
    const double y = normal(random);
    turn = Quat(w, x, y, normal(random)).normalized();
  }
  return turns;
}

/// The same motion on a rig whose joint j is turned by turns[j] against the canonical one.
inline Recording on_other_rig(const Clip& clip, const FrameTurns& turns) {
  Recording recording = to_recording(clip);
  recording.format = "bvh";
  for (int j = 0; j < body_joint_count; ++j) {
    const int parent = body_parents[j];
    Joint& joint = recording.skeleton.joints[j];
    if (parent >= 0) joint.offset = turns[parent].conjugate() * joint.offset;
    if (joint.tip) *joint.tip = turns[j].conjugate() * *joint.tip;
    for (Pose& pose : recording.poses) {
      const Quat above = parent < 0 ? Quat::Identity() : turns[parent];
      pose.rotations[j] = above.conjugate() * pose.rotations[j] * turns[j];
    }
  }
  return recording;
}

inline Recording scaled(Recording recording, double factor) {
  for (Joint& joint : recording.skeleton.joints) {
    joint.offset *= factor;
    if (joint.tip) *joint.tip *= factor;
  }
  for (Pose& pose : recording.poses) {
    pose.root_position *= factor;
    for (Vec3& offset : pose.offsets) offset *= factor;
  }
  return recording;
}

/// The whole world turned; the rig's own frames stay.
inline Recording turned(Recording recording, const Quat& turn) {
  for (Pose& pose : recording.poses) {
    pose.root_position = turn * pose.root_position;
    pose.rotations[0] = turn * pose.rotations[0];
  }
  return recording;
}

inline Recording without_names(Recording recording) {
  for (Joint& joint : recording.skeleton.joints) joint.name.clear();
  return recording;
}

}  // namespace mien::test
