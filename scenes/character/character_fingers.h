#pragma once

#include <array>
#include <vector>

#include "motion/rig/body_mapping.h"
#include "motion/skeleton/hand.h"
#include "motion/skeleton/pose.h"

namespace mien::scenes {

/// The fingers of a character's rig in its bind pose, in which the rig's joints have no rotation.
struct CharacterFingers {
  std::array<int, motion::finger_joint_count> joints;  ///< of the rig; −1: none
  std::array<int, 2> wrists = {-1, -1};                ///< rig joint of the left and right hand
  /// Rotations of the canonical hands, and of each of their joints, in the bind pose; world space.
  std::array<motion::Quat, 2> palms;
  std::array<motion::Quat, motion::finger_joint_count> bind_rotations;
};

/// The fingers of a rig whose bind pose was recognised, after it was turned to +Y up. Joints
/// between a wrist and the first joint of a finger are not among them: they go with the hand.
CharacterFingers character_fingers(const motion::BodyMapping& mapping);

/// Turns the joints of the fingers of a rig that is posed by `pose`, whose rotations are relative
/// to the bind pose, and moves what hangs on them. `fingers` as Pose::fingers; if empty, nothing is
/// changed. A bend that the fingers have in the bind pose counts as a bend.
void bend_fingers(const CharacterFingers& hands, const motion::Skeleton& rig,
                  const std::vector<motion::Quat>& fingers, motion::JointTransforms& pose);

}  // namespace mien::scenes
