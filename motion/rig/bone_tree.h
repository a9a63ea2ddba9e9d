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

  /// Of the bone after a last joint; 0 where the rig tells none.
  double tip_length(int joint) const;

  /// From the parent of a child to the farthest end beyond it.
  double length_through(int child) const { return bone[child] + reach[child]; }
};

/// Lengths are means over some of the frames; of the rig's offsets when there are none.
BoneTree bone_tree(const Skeleton& rig, const std::vector<JointTransforms>& world);

/// The child with the longest way to go, the first of several; −1 when there is none.
int main_child_of(const BoneTree& tree, int joint);

/// The joint and then always the child with the longest way to go.
std::vector<int> longest_chain(const BoneTree& tree, int joint);

}  // namespace mien::motion
