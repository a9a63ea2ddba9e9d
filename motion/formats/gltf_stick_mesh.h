#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "motion/skeleton/skeleton.h"

namespace mien::motion {

/// A mesh that shows the bones of a skeleton at rest, each vertex bound to one joint.
struct StickMesh {
  std::vector<Vec3> positions;                          ///< world space, in the skeleton's unit
  std::vector<int> joints;                              ///< one a vertex
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< counter-clockwise from outside
};

/// Positions of the joints when no joint is turned and the root stands at its own offset.
std::vector<Vec3> bind_positions(const Skeleton& skeleton);

/// An octahedron from every joint to each child and to its tip, bound to that joint. A skeleton
/// without any bone gets one a tenth of the unit long on its root.
StickMesh stick_mesh(const Skeleton& skeleton);

}  // namespace mien::motion
