
#include "motion/formats/gltf/gltf_accessor.h"
#include "scenes/character/character_file.h"
#include "scenes/character/gltf_morphs.h"
#include "scenes/character/placed_mesh.h"

namespace mien::scenes {

namespace {

using motion::Vec3;
using nlohmann::json;

using motion::get_it_again;
constexpr std::size_t most_target_values = 200'000'000;  // vertices of all morph targets
constexpr int triangles_mode = 4;
constexpr int strip_mode = 5;
constexpr int fan_mode = 6;

/// One primitive that is being read.
struct Primitive {
  const CharacterFile& file;
  const json& given;
  std::string use;  ///< "mesh 0, primitive 1"

  int accessor(const std::string& attribute) const {
    const auto attributes = given.find("attributes");
    if (attributes == given.end()) return -1;
    return index_in(file, *attributes, attribute.c_str(), file.gltf.model.accessors.size(), use);
  }

  std::vector<double> numbers(const std::string& attribute, size_t components,
                              size_t vertices) const {
    const int index = accessor(attribute);
    if (index < 0) return {};
    const std::string named = use + ", " + attribute;
    std::vector<double> result = motion::accessor_numbers(file.gltf, index, components, named);
    if (result.size() != components * vertices) refuse(attribute + ": not one per vertex");
    return result;
  }

  [[noreturn]] void refuse(const std::string& wrong) const {
    motion::refuse(file.gltf, use + ": " + wrong, get_it_again);
  }
};

std::vector<Vec3> vectors_of(const std::vector<double>& numbers) {
  std::vector<Vec3> vectors;
  for (size_t i = 0; i + 2 < numbers.size(); i += 3) vectors.emplace_back(numbers.data() + i);
  return vectors;
}

std::vector<int> corners_of(const Primitive& primitive, size_t vertex_count) {
  const int accessor = index_in(primitive.file, primitive.given, "indices",
                                primitive.file.gltf.model.accessors.size(), primitive.use);
  std::vector<int> corners;
  if (accessor < 0) {
    for (size_t v = 0; v < vertex_count; ++v) corners.push_back(static_cast<int>(v));
  } else {
    corners =
        motion::accessor_indices(primitive.file.gltf, accessor, 1, primitive.use + ", indices");
  }
  for (const int corner : corners) {
    if (static_cast<size_t>(corner) >= vertex_count) {
      primitive.refuse("there is no vertex " + std::to_string(corner));
    }
  }
  return corners;
}

std::vector<std::array<int, 3>> triangles_of(const std::vector<int>& corners, int mode) {
  std::vector<std::array<int, 3>> triangles;
  const size_t step = mode == triangles_mode ? 3 : 1;
  for (size_t i = 0; i + 2 < corners.size(); i += step) {
    const bool is_turned = mode == strip_mode && i % 2 == 1;
    const int first = mode == fan_mode ? corners.front() : corners[i];
    triangles.push_back(
        {first, corners[i + (is_turned ? 2 : 1)], corners[i + (is_turned ? 1 : 2)]});
  }
  std::erase_if(triangles,
                [](const auto& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
  return triangles;
}

/// Joints and weights of every vertex; joints as the skin counts them.
std::vector<std::vector<Influence>> influences_of(const Primitive& primitive, size_t vertices,
                                                  size_t joint_count, bool& has_unweighted) {
  std::vector<std::vector<Influence>> influences(vertices);
  for (const std::string set : {"0", "1"}) {
    const int accessor = primitive.accessor("JOINTS_" + set);
    const std::vector<double> weights = primitive.numbers("WEIGHTS_" + set, 4, vertices);
    if (accessor < 0 || weights.empty()) {
      if (set == "0") primitive.refuse("it has a skin but no joints or weights");
      break;
    }
    const std::vector<int> joints = motion::accessor_indices(primitive.file.gltf, accessor, 4,
                                                             primitive.use + ", JOINTS_" + set);
    if (joints.size() != 4 * vertices) primitive.refuse("JOINTS_" + set + ": not one per vertex");
    for (size_t i = 0; i < joints.size(); ++i) {
      if (!(weights[i] > 0.0)) continue;
      if (static_cast<size_t>(joints[i]) >= joint_count) {
        primitive.refuse("its skin has no joint " + std::to_string(joints[i]));
      }
      influences[i / 4].push_back({joints[i], static_cast<float>(weights[i])});
    }
  }
  for (auto& influence : influences) {
    if (influence.empty()) {
      has_unweighted = true;
      influence.push_back({0, 1.0f});
    }
    normalize(influence);
  }
  return influences;
}

void put_uv(const Primitive& primitive, size_t vertices, SkinnedMesh& mesh) {
  const std::vector<double> numbers = primitive.numbers("TEXCOORD_0", 2, vertices);
  for (size_t i = 0; i + 1 < numbers.size(); i += 2) {
    mesh.uv.push_back({static_cast<float>(numbers[i]), static_cast<float>(numbers[i + 1])});
  }
}

/// What primitives have that is not rendered: one warning each, for all primitives together.
struct UnsupportedFeatures {
  bool has_lines = false;
  bool has_unweighted = false;
  bool has_colours = false;

  void add_warnings(std::vector<std::string>& warnings) const {
    if (has_lines) warnings.push_back("Lines and points are not drawn.");
    if (has_unweighted) {
      warnings.push_back("Some vertices have no weights; they follow the skin's first joint.");
    }
    if (has_colours) warnings.push_back("Vertex colours are not drawn.");
  }
};

/// Where the morph targets of a mesh go.
struct MorphPlace {
  int first = 0;             ///< morph of the mesh's first target
  std::size_t& values_left;  ///< of all targets of the file
};

SkinnedMesh mesh_of(const Primitive& primitive, const PlacedMesh& placed, const BindPoseRig& rig,
                    int mode, const MorphPlace& morphs, UnsupportedFeatures& unsupported) {
  const int accessor = primitive.accessor("POSITION");
  if (accessor < 0) primitive.refuse("it has no positions");
  SkinnedMesh mesh;
  mesh.positions = vectors_of(
      motion::accessor_numbers(primitive.file.gltf, accessor, 3, primitive.use + ", POSITION"));
  const size_t vertices = mesh.positions.size();
  if (vertices > most_vertices) primitive.refuse("it has more vertices than supported");
  mesh.triangles = triangles_of(corners_of(primitive, vertices), mode);
  mesh.normals = vectors_of(primitive.numbers("NORMAL", 3, vertices));
  put_uv(primitive, vertices, mesh);
  mesh.morphs = primitive_morphs(primitive.file, primitive.given, primitive.use, vertices,
                                 morphs.first, morphs.values_left);
  if (placed.skin >= 0) {
    const auto skin = static_cast<size_t>(placed.skin);
    const std::vector<int>& joints = primitive.file.gltf.model.skins[skin].joints;
    mesh.influences = influences_of(primitive, vertices, joints.size(), unsupported.has_unweighted);
    place_mesh(rig, joints, rig.skin_to_world[skin], mesh);
  } else {
    mesh.influences.assign(vertices, {{0, 1.0f}});
    place_mesh(rig, {rig.nodes[static_cast<size_t>(placed.joint)]}, {placed.to_world}, mesh);
  }
  complete_normals(mesh);
  mesh.material = 1 + index_in(primitive.file, primitive.given, "material",
                               list_in(primitive.file.json, "materials").size(), primitive.use);
  return mesh;
}

}  // namespace

std::vector<SkinnedMesh> gltf_meshes(const CharacterFile& file, const BindPoseRig& rig,
                                     const GltfMorphs& morphs, std::vector<std::string>& warnings) {
  std::vector<SkinnedMesh> meshes;
  std::size_t vertices = 0;
  std::size_t values_left = most_target_values;
  UnsupportedFeatures unsupported;
  for (size_t m = 0; m < rig.meshes.size(); ++m) {
    const PlacedMesh& placed = rig.meshes[m];
    const json& given = list_in(file.json, "meshes")[static_cast<size_t>(placed.mesh)];
    const json& primitives = list_in(given, "primitives");
    for (size_t p = 0; p < primitives.size(); ++p) {
      const Primitive primitive{
          file, primitives[p],
          "mesh " + std::to_string(placed.mesh) + ", primitive " + std::to_string(p)};
      const int stated = index_in(file, primitives[p], "mode", 7, primitive.use);
      const int mode = stated < 0 ? triangles_mode : stated;
      unsupported.has_lines |= mode < triangles_mode;
      unsupported.has_colours |= primitive.accessor("COLOR_0") >= 0;
      if (mode >= triangles_mode) {
        meshes.push_back(
            mesh_of(primitive, placed, rig, mode, {morphs.first[m], values_left}, unsupported));
        vertices += meshes.back().positions.size();
        if (vertices > most_vertices) primitive.refuse("there are more vertices than supported");
      }
    }
  }
  std::erase_if(meshes, [](const SkinnedMesh& mesh) { return mesh.triangles.empty(); });
  if (meshes.empty()) motion::refuse(file.gltf, "holds no triangles", "export the figure's meshes");
  unsupported.add_warnings(warnings);
  return meshes;
}

}  // namespace mien::scenes
