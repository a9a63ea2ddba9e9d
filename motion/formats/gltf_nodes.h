#pragma once

#include <vector>

#include "motion/formats/gltf_library.h"
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
  std::vector<std::vector<int>> children;  ///< as the file lists them
  std::vector<NodeTransform> at_rest;      ///< without animation
  std::vector<int> parents_first;          ///< all nodes, depth first

  int size() const { return static_cast<int>(parents.size()); }
};

/// The nodes of a file; matrices are split into translation, rotation and scale, shear is left out.
/// Throws mien::Error: children that do not exist, two parents, circles, numbers that are not
/// finite or too few, a rotation of length zero.
GltfNodes parse_nodes(const GltfFile& file);

/// The lowest node at or above all of `wanted`. Throws mien::Error when there is none.
int common_root(const GltfFile& file, const GltfNodes& nodes, const std::vector<int>& wanted);

/// The nodes at or above `wanted` and at or below `root`, depth first.
std::vector<int> nodes_between(const GltfNodes& nodes, int root, const std::vector<int>& wanted);

}  // namespace mien::motion
