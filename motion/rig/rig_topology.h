#pragma once

#include <optional>
#include <vector>

#include "motion/rig/rig_motion.h"

namespace mien::motion {

struct TopologyGuess {
  KeyJoints keys;
  double confidence = 0.0;  ///< 0–1: how clearly anatomy distinguishes left from right
};

/// The key joints of a human rig from the shape of its tree and from how it moves. Names are not
/// needed, but a joint whose name says that it belongs elsewhere (a leg called LowerArm.R) is none,
/// and no joint stands for two of the body.
///
/// Legs and arms are the two pairs of mirror-like chains; the pair whose fork also carries a single
/// chain away from the other fork (the neck) is the arms. Thigh and shank, upper arm and forearm
/// are the two longest bones in a row. Which side is left follows from what can only be forward:
/// toes, the bend of knees and elbows, and the way the body travels. Empty when there are no two
/// such pairs, and for more than 4096 joints.
std::optional<TopologyGuess> key_joints_by_topology(const Recording& recording,
                                                    const std::vector<JointTransforms>& world);

/// Evidence that the body faces (left hip − right hip) × up, mean over the frames: toes, bent
/// knees and elbows, the way it travels. Some units for a clear rig; negative when left and right
/// are exchanged.
double forward_votes(const Recording& recording, const std::vector<JointTransforms>& world,
                     const KeyJoints& keys);

}  // namespace mien::motion
