#include "motion/rig/bone_tree.h"

#include <algorithm>

namespace mien::motion {

namespace {

double mean_bone(const Skeleton& rig, const std::vector<JointTransforms>& world, int joint) {
  if (world.empty()) return rig.joints[joint].offset.norm();
  const size_t stride = std::max<size_t>(1, world.size() / 32);
  double sum = 0.0;
  int count = 0;
  for (size_t t = 0; t < world.size(); t += stride, ++count) {
    const auto& positions = world[t].positions;
    sum += (positions[joint] - positions[rig.joints[joint].parent]).norm();
  }
  return sum / std::max(1, count);
}

}  // namespace

double BoneTree::tip_length(int joint) const {
  return rig.joints[joint].tip ? rig.joints[joint].tip->norm() : 0.0;
}

BoneTree bone_tree(const Skeleton& rig, const std::vector<JointTransforms>& world) {
  BoneTree tree{rig, children_of(rig), {}, {}, 0.0};
  tree.bone.assign(rig.joints.size(), 0.0);
  tree.reach.assign(rig.joints.size(), 0.0);
  for (int j = 1; j < rig.size(); ++j) tree.bone[j] = mean_bone(rig, world, j);
  for (int j = rig.size() - 1; j >= 0; --j) {
    tree.reach[j] = std::max(tree.reach[j], tree.tip_length(j));
    const int parent = rig.joints[j].parent;
    if (parent >= 0) tree.reach[parent] = std::max(tree.reach[parent], tree.length_through(j));
  }
  // From forks only: a rig may hang on a root that stays behind while the body walks away.
  for (int j = 0; j < rig.size(); ++j) {
    if (tree.children[j].size() > 1) tree.size = std::max(tree.size, tree.reach[j]);
  }
  return tree;
}

int main_child_of(const BoneTree& tree, int joint) {
  int longest = -1;
  for (const int child : tree.children[joint]) {
    if (longest < 0 || tree.length_through(child) > tree.length_through(longest)) longest = child;
  }
  return longest;
}

std::vector<int> longest_chain(const BoneTree& tree, int joint) {
  std::vector<int> chain;
  for (; joint >= 0; joint = main_child_of(tree, joint)) chain.push_back(joint);
  return chain;
}

}  // namespace mien::motion
