#pragma once

#include <vector>

#include "motion/skeleton/pose.h"
#include "motion/skeleton/skeleton.h"

namespace mien::motion {

/// A rig's tree with its mean bone lengths, in the rig's unit. The bone of a joint is the segment
/// from its parent to the joint. Holds a reference to the rig.
struct BoneTree {
  const Skeleton& rig;
  std::vector<std::vector<int>> children;
  std::vector<double> bone;   ///< length of the joint's bone
  std::vector<double> reach;  ///< length of the longest path from the joint down to an end
  double size = 0.0;          ///< length of the longest path from a fork down to an end

  /// Length of the bone beyond a leaf joint (to its tip); 0 if it has no tip.
  double tip_length(int joint) const;

  /// Length of the longest path from the parent of `child` through `child` to an end.
  double length_through(int child) const { return bone[child] + reach[child]; }
};

/// Makes the tree of a rig. Lengths are means over a sample of the frames; without frames, those of
/// the rig's offsets.
BoneTree bone_tree(const Skeleton& rig, const std::vector<JointTransforms>& world);

/// The child with the longest chain (the first of equal ones); −1 if there is none.
int main_child_of(const BoneTree& tree, int joint);

/// The joint followed by its longest chain of descendants.
std::vector<int> longest_chain(const BoneTree& tree, int joint);

}  // namespace mien::motion
