#pragma once

#include <array>
#include <string>
#include <vector>

#include "motion/skeleton/body.h"

namespace mien::motion {

/// The joints of a rig that correspond to one joint of the canonical body.
struct MappedJoint {
  std::vector<int> group;  ///< rig joints from root to tip; empty when the rig has none
  int position = -1;    ///< rig joint at the position of the canonical joint; −1 without a group
  bool at_tip = false;  ///< the canonical joint lies at the tip ("End Site") of `position` and does
                        ///< not rotate
  double confidence = 0.0;  ///< 0 (guessed by proportion) to 1 (known by name)
  std::string found_by;     ///< "name", "topology", "end site", "missing"

  /// Rig joint whose rotation the canonical joint follows; −1 if it does not rotate relative to its
  /// parent.
  int rotation() const { return at_tip || group.empty() ? -1 : group.back(); }
};

using MappedJoints = std::array<MappedJoint, body_joint_count>;

/// The joints of one arm and one leg that determine the groups. −1: missing in the rig.
struct KeyLimbs {
  int upper_arm = -1;
  int forearm = -1;
  int wrist = -1;
  int thigh = -1;
  int shank = -1;
  int ankle = -1;
  int toe = -1;
};

/// The joints that determine a human rig; those between them belong to a group or are skipped.
struct KeyJoints {
  int pelvis = -1;
  int chest = -1;  ///< where the arms branch off
  int head = -1;
  int neck = -1;  ///< only in a rig without a head: the neck's last joint
  KeyLimbs left;
  KeyLimbs right;
  std::vector<int> by_shape;  ///< joints found by shape, since their names did not identify them
};

/// The groups of a rig: spine joints above the pelvis up to the chest joint are divided between
/// Spine and Chest (the lower half is Spine; a single joint, the chest joint, is Chest), joints
/// between chest and head form the neck, and joints between chest and upper arm the clavicle;
/// joints between the fork of the legs and a thigh belong to the hip. A missing wrist, ankle or toe
/// is placed at the tip of the preceding bone if that bone has a tip. Joints in `by_shape` are
/// marked as found by "topology" and have a lower confidence.
MappedJoints groups_of(const Skeleton& rig, const KeyJoints& keys, double confidence,
                       const std::string& found_by);

/// Whether no rig joint is mapped to more than one joint of the canonical body (joints at tips are
/// not counted).
bool are_disjoint(const MappedJoints& joints);

/// Joints on the path from `ancestor` (excluded) down to `descendant` (included). Empty if
/// `ancestor` is not an ancestor of `descendant`.
std::vector<int> path_down(const Skeleton& rig, int ancestor, int descendant);

/// Lowest common ancestor; a joint counts as its own ancestor. Both must be ≥ 0.
int common_ancestor(const Skeleton& rig, int a, int b);

}  // namespace mien::motion
