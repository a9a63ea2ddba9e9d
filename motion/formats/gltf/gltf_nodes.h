#pragma once

#include <vector>

#include "motion/formats/gltf/gltf_library.h"
#include "motion/math/geometry.h"

namespace mien::motion {

/// Transform of a node relative to its parent: scale, then rotation, then translation.
struct NodeTransform {
  Vec3 translation = Vec3::Zero();
  Quat rotation = Quat::Identity();
  Vec3 scale = Vec3::Ones();
};

/// The nodes of a file as a forest.
struct GltfNodes {
  std::vector<int> parents;                ///< −1 for roots
  std::vector<std::vector<int>> children;  ///< in the order of the file
  std::vector<NodeTransform> at_rest;      ///< transforms without animation
  std::vector<int> parents_first;          ///< all nodes, depth first (parents before children)

  int size() const { return static_cast<int>(parents.size()); }
};

/// The nodes of a file. Matrices are decomposed into translation, rotation and scale; shear is
/// ignored. Throws mien::Error for children that do not exist, nodes with two parents, cycles,
/// missing or non-finite numbers, and rotations of length zero.
GltfNodes parse_nodes(const GltfFile& file);

/// The lowest common ancestor of the `wanted` nodes, possibly one of them. Throws mien::Error if
/// there is none.
int common_root(const GltfFile& file, const GltfNodes& nodes, const std::vector<int>& wanted);

/// The nodes on the paths from `root` to the `wanted` nodes, inclusive, depth first.
std::vector<int> nodes_between(const GltfNodes& nodes, int root, const std::vector<int>& wanted);

}  // namespace mien::motion
