#pragma once

#include <optional>
#include <vector>

#include "motion/rig/rig_motion.h"

namespace mien::motion {

struct TopologyGuess {
  KeyJoints keys;
  double confidence = 0.0;  ///< 0.5–0.9: how clearly anatomy distinguishes left from right
};

/// Finds the key joints of a human rig from the shape of its tree and from its motion. Names are
/// not needed, but a joint whose name contradicts its role (a leg called LowerArm.R) is rejected,
/// and no rig joint is used twice.
///
/// Legs and arms are the two pairs of symmetric chains. The arms are the pair from whose fork a
/// third chain (the neck) leads away from the legs. Thigh and shank, or upper arm and forearm, are
/// those two consecutive bones of the chain that are longest together. The left side follows from
/// cues for the forward direction: toes, flexion of knees and elbows, and the direction of travel.
/// Empty if there are no two such pairs, no frames, or more than 4096 joints.
std::optional<TopologyGuess> key_joints_by_topology(const Recording& recording,
                                                    const std::vector<JointTransforms>& world);

/// Evidence that the body faces (left hip − right hip) × up, as a sum of cues averaged over
/// frames: toes, flexed knees and elbows, direction of travel. Dimensionless; above 1 for an
/// unambiguous rig, negative if left and right are exchanged.
double forward_votes(const Recording& recording, const std::vector<JointTransforms>& world,
                     const KeyJoints& keys);

}  // namespace mien::motion
