#pragma once

#include <optional>
#include <vector>

#include "motion/rig/rig_motion.h"

namespace mien::motion {

struct TopologyGuess {
  KeyJoints keys;
  double confidence = 0.0;  ///< 0–1: how clearly anatomy distinguishes left from right
};

/// Finds the key joints of a human rig from the shape of its tree and from its motion. Names are
/// not needed, but a joint whose name contradicts its role (a leg called LowerArm.R) is rejected,
/// and no rig joint is used twice.
///
/// Legs and arms are the two pairs of symmetric chains; the arms are the pair with a third chain
/// (the neck) at their fork, which leads away from the fork of the legs. Thigh and shank, upper arm
/// and forearm are the two longest consecutive bones. The left side follows from cues for the
/// forward direction: toes, flexion of knees and elbows, and the direction of travel. Empty if
/// there are no two such pairs, or more than 4096 joints.
std::optional<TopologyGuess> key_joints_by_topology(const Recording& recording,
                                                    const std::vector<JointTransforms>& world);

/// Evidence that the body faces (left hip − right hip) × up, as a sum of cues averaged over the
/// frames: toes, flexed knees and elbows, direction of travel. Dimensionless; above 1 for an
/// unambiguous rig, negative if left and right are exchanged.
double forward_votes(const Recording& recording, const std::vector<JointTransforms>& world,
                     const KeyJoints& keys);

}  // namespace mien::motion
