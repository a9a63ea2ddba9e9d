#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "motion/skeleton/hand.h"
#include "motion/skeleton/skeleton.h"

namespace mien::motion {

/// What the name of a joint says of fingers.
struct FingerName {
  bool is_known = false;  ///< whether it names a finger
  Finger finger = Finger::thumb;
  int number = -1;  ///< as in "Finger1", whose count begins elsewhere in each rig; −1: `finger`
  bool states_segment = false;  ///< "Proximal" and the like
};

/// Reads the name of a joint below a wrist in the spellings of common rigs: "LeftHandThumb1",
/// "LeftInHandIndex", "leftIndexProximal", "J_Bip_L_Little2", "left_pinky1", "LeftFinger2Medial",
/// "Bip01 L Finger01", "LeftSecondPP" (MVN), "LIndex1", "thumb_01_l", "f_ring.02.L".
FingerName read_finger_name(std::string_view name);

/// The joints of a rig that correspond to those of hand.h.
struct FingerJoints {
  std::array<int, finger_joint_count> joints;  ///< −1: none
  std::array<int, 2 * fingers_per_hand> ends;  ///< joint at the tip of each finger; −1: none
  std::array<bool, 2> is_hand = {};            ///< left, right: enough fingers for a hand
};

/// Finds the fingers below the wrists (−1: none). The names state which finger a joint belongs to;
/// its segment follows from the order in the tree: the last three joints of a finger are its
/// segments, what precedes them (metacarpals) only adds to the rotation of the first. Joints named
/// as ends ("LeftHandIndex4" after three others, "…_end", "…Tip", "…Nub") do not count. A hand
/// needs all fingers but the thumb, or thumb, index and middle finger; fewer are ignored.
FingerJoints finger_joints(const Skeleton& rig, int left_wrist, int right_wrist);

}  // namespace mien::motion
