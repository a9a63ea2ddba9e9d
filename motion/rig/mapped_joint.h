#pragma once

#include <array>
#include <string>
#include <vector>

#include "motion/skeleton/body.h"

namespace mien::motion {

/// The joints of a rig that correspond to one joint of the canonical body.
struct MappedJoint {
  std::vector<int> group;  ///< rig joints from root to tip; empty when the rig has none
  int position = -1;    ///< rig joint that sits where the canonical joint sits; −1 with no group
  bool at_tip = false;  ///< it sits at the tip ("End Site") of `position` and does not turn
  double confidence = 0.0;  ///< 0 (guessed by proportion) to 1 (known by name)
  std::string found_by;     ///< "name", "topology", "end site", "missing"

  /// Rig joint whose rotation the canonical joint follows; −1 when it keeps still on its parent.
  int rotation() const { return at_tip || group.empty() ? -1 : group.back(); }
};

using MappedJoints = std::array<MappedJoint, body_joint_count>;

/// The joints of one arm and one leg from which the groups follow. −1: the rig has none.
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
  int neck = -1;  ///< of a rig without a head: the neck's last joint
  KeyLimbs left;
  KeyLimbs right;
  std::vector<int> by_shape;  ///< those of a named rig that were found by its shape, not by name
};

/// The groups of a rig: spine joints between pelvis and chest are shared out to Spine and Chest
/// (the lower half, rounded up, is Spine), those between chest and head are the neck, those between
/// chest and upper arm the clavicle. A missing wrist or toe sits at the tip of the bone before it
/// when the rig gives one. What stands for a joint in `by_shape` is found by "topology" and less
/// sure.
MappedJoints groups_of(const Skeleton& rig, const KeyJoints& keys, double confidence,
                       const std::string& found_by);

/// Whether no joint of the rig is mapped to two joints of the body.
bool are_disjoint(const MappedJoints& joints);

/// Joints from `ancestor` (left out) down to `descendant` (included). Empty when it is no ancestor.
std::vector<int> path_down(const Skeleton& rig, int ancestor, int descendant);

/// Lowest common ancestor; a joint counts as its own ancestor. Both must be ≥ 0.
int common_ancestor(const Skeleton& rig, int a, int b);

}  // namespace mien::motion
