#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "motion/rig/finger_joints.h"
#include "motion/rig/rig_motion.h"

namespace mien::motion {

/// Mapping of a rig's fingers to those of hand.h.
struct HandMapping {
  std::array<int, finger_joint_count> joints;  ///< rig joint of each; −1: none
  /// Constants A_j: global rotation of a canonical finger joint = that of the rig joint · A_j.
  std::array<Quat, finger_joint_count> calibration;
  /// Left, right: rotation of the canonical hand (palm down, fingers along ±X at rest) in the frame
  /// of the rig joint that the wrist follows, by the places of the knuckles. The first joint of a
  /// finger is turned against this, so that fingers bend towards the palm even where the wrist's
  /// own calibration has the hand turned about the forearm.
  std::array<Quat, 2> palm;
  std::array<bool, 2> is_hand = {};  ///< left, right: whether the rig has it

  bool has(bool left) const { return is_hand[left ? 0 : 1]; }
  bool any() const { return is_hand[0] || is_hand[1]; }
};

/// The mapping of a rig without fingers.
HandMapping no_hands();

/// Finds the fingers of a rig (finger_joints.h) and calibrates them: in a reference pose, each
/// canonical bone has the direction of the rig's bone, and no twist about it against the bone
/// before, or for a finger's first against the palm. Bends of the reference pose thereby count as
/// bends. The reference is the rig's zero pose if `zero_pose_is_figure`, otherwise the frame in
/// which the fingers are straightest. If `is_own`, the rig is the canonical body and hand: all
/// constants are the identity. A hand whose knuckles are in one place or one line is left out.
HandMapping hand_mapping(std::span<const RigMotion> motions, bool zero_pose_is_figure, bool is_own);

/// Rotations of all finger joints (Pose::fingers) in a frame of the rig. Joints that a hand lacks
/// are straight; a hand that the rig lacks is at ease (relaxed_fingers).
std::vector<Quat> finger_rotations(const RigMotion& motion, const JointTransforms& frame,
                                   const HandMapping& hands);

/// Whether all fingers have the rig's zero rotations in all frames: then nothing of the hands was
/// recorded.
bool are_fingers_unrecorded(const Recording& recording, const HandMapping& hands);

/// Joints of hand.h that the recognised hands lack, by name.
std::vector<std::string> missing_finger_joints(const HandMapping& hands);

/// Sentences on what is missing; empty if there is no hand at all, or if both are complete.
std::vector<std::string> hand_warnings(const HandMapping& hands);

}  // namespace mien::motion
