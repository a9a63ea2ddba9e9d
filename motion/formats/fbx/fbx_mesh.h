#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "motion/formats/fbx/fbx_scene.h"
#include "motion/math/geometry.h"

namespace mien::motion {

/// Texture coordinates with v = 0 at the lower edge of the picture.
struct FbxUvSet {
  std::string name;
  std::vector<std::array<float, 2>> uv;  ///< of each corner
};

/// What one bone moves of a mesh.
struct FbxCluster {
  int model = -1;                                         ///< the bone
  Eigen::Affine3d to_bone = Eigen::Affine3d::Identity();  ///< mesh space → bone, in the bind pose
  std::optional<Eigen::Affine3d> bind;  ///< bone → world in the bind pose, if the file states it
  std::vector<int> vertices;
  std::vector<float> weights;  ///< as many as vertices; those of a vertex need not sum to 1
};

/// A polygon mesh with its skin. Lengths are in the file's unit. A corner is where a polygon meets
/// a vertex; polygons are split into triangles that fan out from one corner.
struct FbxMesh {
  std::string name;
  int model = -1;                             ///< on which it hangs
  std::vector<Vec3> positions;                ///< of the vertices, mesh space
  std::vector<int> corners;                   ///< the vertex of each corner
  std::vector<std::array<int, 3>> triangles;  ///< corners, counter-clockwise seen from outside
  std::vector<int> triangle_materials;        ///< indices in `materials`; empty if there are none
  std::vector<std::array<float, 3>> normals;  ///< of each corner, of any length; may be empty
  std::vector<FbxUvSet> uv_sets;
  std::vector<int> materials;        ///< objects of the file (fbx_material.h)
  std::vector<FbxCluster> clusters;  ///< empty if the mesh is not skinned
  bool is_visible = true;
  bool has_colours = false;       ///< of its vertices, which are not read
  bool has_blend_shapes = false;  ///< which are not read
  /// Mesh space → the space of the model (GeometricTranslation, -Rotation and -Scaling).
  Eigen::Affine3d geometric = Eigen::Affine3d::Identity();
};

/// The meshes of a file, one for each model that one hangs on. Throws mien::Error if an index does
/// not exist, lists do not match, numbers are not finite or all meshes together have more than 2^26
/// vertices, corners and weights.
std::vector<FbxMesh> fbx_meshes(const FbxScene& scene);

/// The vertices in the world of the file with the models at the given places (fbx_scene.h): by
/// linear blend skinning with weights scaled to a sum of 1; vertices without weights hang on the
/// model.
std::vector<Vec3> posed_vertices(const FbxMesh& mesh, const std::vector<FbxPlace>& places);

}  // namespace mien::motion
