#include "scenes/character/gltf_morphs.h"

#include <algorithm>
#include <map>

#include "motion/formats/gltf/gltf_accessor.h"
#include "scenes/character/vrm_expressions.h"

namespace mien::scenes {

namespace {

using motion::Vec3;
using nlohmann::json;

constexpr std::size_t most_morphs = 4096;

const json& mesh_at(const CharacterFile& file, int mesh) {
  return list_in(file.json, "meshes")[static_cast<std::size_t>(mesh)];
}

std::size_t target_count(const CharacterFile& file, int mesh) {
  std::size_t count = 0;
  for (const json& primitive : list_in(mesh_at(file, mesh), "primitives"))
    count = std::max(count, list_in(primitive, "targets").size());
  return count;
}

const json& list_of_names(const json& object) {
  static const json none = json::array();
  const auto extras = object.is_object() ? object.find("extras") : object.end();
  return object.is_object() && extras != object.end() ? list_in(*extras, "targetNames") : none;
}

/// The three numbers of each vertex under an attribute of a target; empty without it.
std::vector<double> target_numbers(const CharacterFile& file, const json& target,
                                   const char* attribute, std::size_t vertices,
                                   const std::string& use) {
  const int accessor = index_in(file, target, attribute, file.gltf.model.accessors.size(), use);
  if (accessor < 0) return {};
  const std::string named = use + ", " + attribute;
  if (motion::accessor_count(file.gltf, accessor, named) != vertices)
    motion::refuse(file.gltf, named + ": not one per vertex", motion::get_it_again);
  return motion::accessor_numbers(file.gltf, accessor, 3, named);
}

MorphTarget target_of(const std::vector<double>& positions, const std::vector<double>& normals,
                      std::size_t vertices) {
  MorphTarget target;
  const auto vector_at = [](const std::vector<double>& numbers, std::size_t vertex) -> Vec3 {
    return numbers.empty() ? Vec3(Vec3::Zero()) : Vec3(numbers.data() + 3 * vertex);
  };
  for (std::size_t v = 0; v < vertices; ++v) {
    const Vec3 move = vector_at(positions, v), turn = vector_at(normals, v);
    if (move == Vec3::Zero() && turn == Vec3::Zero()) continue;
    target.vertices.push_back(static_cast<int>(v));
    target.positions.push_back(move);
    if (!normals.empty()) target.normals.push_back(turn);
  }
  return target;
}

}  // namespace

std::vector<std::string> target_names(const CharacterFile& file, int mesh) {
  const json& given = mesh_at(file, mesh);
  const json* stated = &list_of_names(given);
  const json& primitives = list_in(given, "primitives");
  if (stated->empty() && !primitives.empty()) stated = &list_of_names(primitives.front());
  std::vector<std::string> names;
  for (std::size_t t = 0; t < target_count(file, mesh); ++t) {
    const bool is_named =
        t < stated->size() && (*stated)[t].is_string() && !(*stated)[t].get<std::string>().empty();
    names.push_back(is_named ? (*stated)[t].get<std::string>() : "target_" + std::to_string(t));
  }
  return names;
}

GltfMorphs gltf_morphs(const CharacterFile& file, const std::vector<PlacedMesh>& placed) {
  GltfMorphs morphs;
  for (const PlacedMesh& mesh : placed) {
    const std::size_t count = target_count(file, mesh.mesh);
    if (count > most_morphs - static_cast<std::size_t>(morphs.count))
      motion::refuse(file.gltf, "there are more morph targets than supported",
                     "export the figure with fewer");
    morphs.first.push_back(morphs.count);
    morphs.names.push_back(target_names(file, mesh.mesh));
    morphs.count += static_cast<int>(count);
  }
  return morphs;
}

std::vector<MorphTarget> primitive_morphs(const CharacterFile& file, const json& primitive,
                                          const std::string& use, std::size_t vertices,
                                          int first_morph, std::size_t& values_left) {
  std::vector<MorphTarget> morphs;
  const json& targets = list_in(primitive, "targets");
  for (std::size_t t = 0; t < targets.size(); ++t) {
    const std::string named = use + ", target " + std::to_string(t);
    if (vertices > values_left)
      motion::refuse(file.gltf, named + ": the targets have more vertices than supported",
                     "export the figure with fewer");
    values_left -= vertices;
    MorphTarget target =
        target_of(target_numbers(file, targets[t], "POSITION", vertices, named),
                  target_numbers(file, targets[t], "NORMAL", vertices, named), vertices);
    target.morph = first_morph + static_cast<int>(t);
    if (!target.vertices.empty()) morphs.push_back(std::move(target));
  }
  return morphs;
}

FaceControls gltf_face(const CharacterFile& file, const std::vector<PlacedMesh>& placed,
                       const GltfMorphs& morphs, std::vector<std::string>& warnings) {
  FaceControls face;
  face.morph_count = morphs.count;
  face.controls = vrm_expressions(file, placed, morphs, warnings);
  const std::size_t first_target = face.controls.size();
  std::map<std::string, std::size_t> known;
  for (std::size_t m = 0; m < placed.size(); ++m) {
    for (std::size_t t = 0; t < morphs.names[m].size(); ++t) {
      const std::string& name = morphs.names[m][t];
      const auto [at, is_new] = known.try_emplace(name, first_target + known.size());
      if (is_new) face.controls.emplace_back().name = name;
      face.controls[at->second].morphs.emplace_back(morphs.first[m] + static_cast<int>(t), 1.0);
    }
  }
  return face;
}

}  // namespace mien::scenes
