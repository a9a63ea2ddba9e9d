#pragma once

#include <vector>

#include "motion/skeleton/pose.h"
#include "motion/skeleton/skeleton.h"

namespace mien::motion {

/// A rig's tree with its mean bone lengths, in the rig's unit. A joint's bone leads to it from its
/// parent. Refers to the rig.
struct BoneTree {
  const Skeleton& rig;
  std::vector<std::vector<int>> children;
  std::vector<double> bone;   ///< length of the bone that leads to the joint
  std::vector<double> reach;  ///< length of the longest way from the joint to an end
  double size = 0.0;          ///< longest way from a fork to an end

  /// Length of the bone after a leaf joint; 0 if the rig has none.
  double tip_length(int joint) const;

  /// Length from the parent of a child to the farthest end through it.
  double length_through(int child) const { return bone[child] + reach[child]; }
};

/// Makes the tree of a rig. Lengths are means over some of the frames, or those of the rig's
/// offsets without frames.
BoneTree bone_tree(const Skeleton& rig, const std::vector<JointTransforms>& world);

/// The child with the longest chain, the first of several; −1 when there is none.
int main_child_of(const BoneTree& tree, int joint);

/// The joint followed by its longest chain of descendants.
std::vector<int> longest_chain(const BoneTree& tree, int joint);

}  // namespace mien::motion
