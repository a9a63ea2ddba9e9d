#include <array>
#include <map>
#include <tuple>
#include <utility>

#include "motion/error.h"
#include "scenes/character/fbx_character.h"
#include "scenes/character/placed_mesh.h"

namespace mien::scenes {

namespace {

using motion::FbxMesh;
using motion::Vec3;

/// The influences of each vertex; joints are clusters of the mesh. Without clusters, all follow the
/// one joint that the mesh is attached to.
std::vector<std::vector<Influence>> influences_of(const FbxMesh& mesh, bool& has_unweighted) {
  std::vector<std::vector<Influence>> influences(mesh.positions.size());
  for (size_t c = 0; c < mesh.clusters.size(); ++c) {
    const motion::FbxCluster& cluster = mesh.clusters[c];
    for (size_t i = 0; i < cluster.vertices.size(); ++i) {
      if (!(cluster.weights[i] > 0.0f)) continue;
      influences[static_cast<size_t>(cluster.vertices[i])].push_back(
          {static_cast<int>(c), cluster.weights[i]});
    }
  }
  for (auto& influence : influences) {
    if (influence.empty()) {
      has_unweighted |= !mesh.clusters.empty();
      influence.push_back({0, 1.0f});
    }
    normalize(influence);
  }
  return influences;
}

/// The set of texture coordinates of a material: that of its name, else the first; null if the mesh
/// has none.
const motion::FbxUvSet* uv_set_of(const FbxMesh& mesh, const std::string& name) {
  for (const motion::FbxUvSet& set : mesh.uv_sets) {
    if (set.name == name) return &set;
  }
  return mesh.uv_sets.empty() ? nullptr : &mesh.uv_sets.front();
}

/// A vertex of the file with the normal and texture coordinates of a corner.
using CornerKey = std::tuple<int, std::array<float, 3>, std::array<float, 2>>;

/// Gathers the triangles of one material of a mesh.
struct Surface {
  const FbxMesh& mesh;
  const std::vector<std::vector<Influence>>& influences;
  const motion::FbxUvSet* uv_set = nullptr;
  SkinnedMesh made{};
  std::map<CornerKey, int> vertices{};

  int vertex_of(int corner) {
    const auto c = static_cast<size_t>(corner);
    const auto v = static_cast<size_t>(mesh.corners[c]);
    CornerKey key{mesh.corners[c], {}, {}};
    if (!mesh.normals.empty()) std::get<1>(key) = mesh.normals[c];
    // In render's textures v grows downwards.
    if (uv_set != nullptr) std::get<2>(key) = {uv_set->uv[c][0], 1.0f - uv_set->uv[c][1]};
    const auto [known, is_new] = vertices.try_emplace(key, static_cast<int>(made.positions.size()));
    if (!is_new) return known->second;
    made.positions.push_back(mesh.positions[v]);
    made.influences.push_back(influences[v]);
    if (uv_set != nullptr) made.uv.push_back(std::get<2>(key));
    const auto& [x, y, z] = std::get<1>(key);
    if (!mesh.normals.empty()) made.normals.emplace_back(x, y, z);
    return known->second;
  }

  void add(const std::array<int, 3>& corners) {
    const std::array<int, 3> t = {vertex_of(corners[0]), vertex_of(corners[1]),
                                  vertex_of(corners[2])};
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) made.triangles.push_back(t);
  }
};

/// The surfaces of a mesh by the objects of their materials, −1 for none.
std::map<int, Surface> surfaces_of(const FbxMesh& mesh, const FbxPaint& paint,
                                   const std::vector<std::vector<Influence>>& influences) {
  std::map<int, Surface> surfaces;
  for (size_t t = 0; t < mesh.triangles.size(); ++t) {
    const int object = mesh.triangle_materials.empty()
                           ? -1
                           : mesh.materials[static_cast<size_t>(mesh.triangle_materials[t])];
    auto found = surfaces.find(object);
    if (found == surfaces.end()) {
      const auto name = paint.uv_set_of.find(object);
      const motion::FbxUvSet* set =
          uv_set_of(mesh, name == paint.uv_set_of.end() ? "" : name->second);
      found = surfaces.emplace(object, Surface{mesh, influences, set}).first;
    }
    found->second.add(mesh.triangles[t]);
  }
  return surfaces;
}

/// What is not drawn: one warning each, for all meshes together.
struct FbxOmissions {
  bool has_unweighted = false;
  bool has_blend_shapes = false;
  bool has_colours = false;

  void add_warnings(std::vector<std::string>& warnings) const {
    if (has_unweighted) {
      warnings.push_back("Some vertices have no weights; they follow the skin's first joint.");
    }
    if (has_blend_shapes) warnings.push_back("Blend shapes are not applied.");
    if (has_colours) warnings.push_back("Vertex colours are not drawn.");
  }
};

/// Nodes of the joints that move a mesh, with its transforms into the bind pose.
std::pair<std::vector<int>, std::vector<Eigen::Affine3d>> placing_of(const FbxCharacter& character,
                                                                     const PlacedMesh& placed) {
  const BindPoseRig& rig = character.rig;
  if (placed.skin < 0) return {{rig.nodes[static_cast<size_t>(placed.joint)]}, {placed.to_world}};
  std::vector<int> nodes;
  for (const auto& cluster : character.meshes[static_cast<size_t>(placed.mesh)].clusters)
    nodes.push_back(cluster.model);
  return {nodes, rig.skin_to_world[static_cast<size_t>(placed.skin)]};
}

}  // namespace

std::vector<SkinnedMesh> fbx_skinned_meshes(const FbxCharacter& character, const FbxPaint& paint,
                                            std::vector<std::string>& warnings) {
  std::vector<SkinnedMesh> meshes;
  size_t vertices = 0;
  FbxOmissions omitted;
  for (const PlacedMesh& placed : character.rig.meshes) {
    const FbxMesh& mesh = character.meshes[static_cast<size_t>(placed.mesh)];
    omitted.has_blend_shapes |= mesh.has_blend_shapes;
    omitted.has_colours |= mesh.has_colours;
    const auto influences = influences_of(mesh, omitted.has_unweighted);
    const auto [nodes, to_world] = placing_of(character, placed);
    for (auto& [object, surface] : surfaces_of(mesh, paint, influences)) {
      SkinnedMesh& made = surface.made;
      vertices += made.positions.size();
      if (vertices > most_vertices)
        throw Error({character.scene.document.file}, "there are more vertices than supported",
                    "reduce its meshes to 4 million vertices");
      if (made.triangles.empty()) continue;
      place_mesh(character.rig, nodes, to_world, made);
      complete_normals(made);
      const auto material = paint.material_of.find(object);
      made.material = material == paint.material_of.end() ? 0 : material->second;
      meshes.push_back(std::move(made));
    }
  }
  if (meshes.empty())
    throw Error({character.scene.document.file}, "holds no triangles",
                "export the figure's meshes");
  omitted.add_warnings(warnings);
  return meshes;
}

}  // namespace mien::scenes
