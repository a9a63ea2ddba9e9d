#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "motion/math/geometry.h"

namespace mien::scenes {

struct SkinnedMesh;

/// A change of a mesh's shape: of the vertices that it moves, what weight 1 adds to their positions
/// and normals in the bind pose (glTF 2.0, morph targets).
struct MorphTarget {
  int morph = 0;                        ///< index of its weight among those of the figure
  std::vector<int> vertices;            ///< ascending
  std::vector<motion::Vec3> positions;  ///< one per vertex of `vertices`
  std::vector<motion::Vec3> normals;    ///< the same; empty until complete_morph_normals
};

/// The vertices of a mesh in its bind pose.
struct MeshShape {
  std::vector<motion::Vec3> positions;
  std::vector<motion::Vec3> normals;  ///< unit
};

/// Whether any target of the mesh has a weight other than 0.
bool is_morphed(const SkinnedMesh& mesh, std::span<const double> weights);

/// The mesh's vertices after its targets: positions and normals plus the weighted sums of the
/// targets', normals made unit. `weights` has one for each morph of the figure.
MeshShape morphed_shape(const SkinnedMesh& mesh, std::span<const double> weights);

/// Gives targets without normals the change of the mesh's normals between weights 0 and 1, by
/// area-weighted means of the triangles' normals. Vertices at the same place with the same normal,
/// as on both sides of a seam of the texture, count as one.
void complete_morph_normals(SkinnedMesh& mesh);

}  // namespace mien::scenes
