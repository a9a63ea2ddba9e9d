#include "scenes/skinning/skinned_glb.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>

#include <nlohmann/json.hpp>

#include "motion/formats/gltf/glb_buffer.h"
#include "render/scene/texture_io.h"

namespace mien::scenes {

namespace {

using Json = nlohmann::ordered_json;
using motion::GlbBuffer;
using motion::GlbElement;
using motion::GlbUse;

constexpr std::size_t joints_a_vertex = 4;

void append(std::vector<float>& numbers, const motion::Vec3& v) {
  for (const double coordinate : v) numbers.push_back(static_cast<float>(coordinate));
}

/// The influences of all vertices as two attributes.
struct VertexJoints {
  std::vector<std::uint16_t> joints;
  std::vector<float> weights;
};

VertexJoints vertex_joints(const SkinnedMesh& mesh) {
  VertexJoints made;
  for (const std::vector<Influence>& influences : mesh.influences) {
    std::vector<Influence> largest = influences;
    std::stable_sort(largest.begin(), largest.end(),
                     [](const Influence& a, const Influence& b) { return a.weight > b.weight; });
    largest.resize(joints_a_vertex);
    float sum = 0.0f;
    for (const Influence& one : largest) sum += one.weight;
    for (const Influence& one : largest) {
      made.joints.push_back(static_cast<std::uint16_t>(one.joint));
      made.weights.push_back(one.weight / sum);
    }
  }
  return made;
}

Json primitive_of(const SkinnedMesh& mesh, GlbBuffer& buffer) {
  std::vector<float> positions, normals, places;
  for (const motion::Vec3& position : mesh.positions) append(positions, position);
  for (const motion::Vec3& normal : mesh.normals) append(normals, normal);
  for (const auto& [u, v] : mesh.uv) places.insert(places.end(), {u, v});
  std::vector<std::uint32_t> indices;
  for (const auto& triangle : mesh.triangles) {
    for (const int vertex : triangle) indices.push_back(static_cast<std::uint32_t>(vertex));
  }
  const VertexJoints followed = vertex_joints(mesh);
  constexpr GlbUse use = GlbUse::vertices;
  Json attributes;
  attributes["POSITION"] = add_bounded(buffer, positions, GlbElement::vec3, use);
  attributes["NORMAL"] = add(buffer, normals, GlbElement::vec3, use);
  if (!places.empty()) attributes["TEXCOORD_0"] = add(buffer, places, GlbElement::vec2, use);
  attributes["JOINTS_0"] = add(buffer, followed.joints, GlbElement::vec4, use);
  attributes["WEIGHTS_0"] = add(buffer, followed.weights, GlbElement::vec4, use);
  return {{"attributes", attributes},
          {"indices", add(buffer, indices, GlbElement::scalar, GlbUse::indices)},
          {"material", mesh.material}};
}

/// What weight 1 adds to the mesh's positions and normals.
Json target_of(const SkinnedMesh& mesh, const MorphTarget& target, GlbBuffer& buffer) {
  const std::vector<std::uint32_t> vertices(target.vertices.begin(), target.vertices.end());
  const auto added = [&](const std::vector<motion::Vec3>& changes) {
    std::vector<float> numbers;
    for (const motion::Vec3& change : changes) append(numbers, change);
    return add_sparse(buffer, mesh.positions.size(), vertices, numbers, GlbElement::vec3);
  };
  Json attributes = {{"POSITION", added(target.positions)}};
  if (!target.normals.empty()) attributes["NORMAL"] = added(target.normals);
  return attributes;
}

/// A mesh of its own for one that has morph targets.
Json morphed_mesh(const SkinnedMesh& mesh, const std::vector<std::string>& morphs,
                  GlbBuffer& buffer) {
  Json primitive = primitive_of(mesh, buffer);
  Json names = Json::array(), numbers = Json::array();
  for (const MorphTarget& target : mesh.morphs) {
    primitive["targets"].push_back(target_of(mesh, target, buffer));
    names.push_back(morphs[static_cast<std::size_t>(target.morph)]);
    numbers.push_back(target.morph);
  }
  return {{"name", "face"},
          {"primitives", Json::array({primitive})},
          {"extras", {{"targetNames", names}, {"morphs", numbers}}}};
}

/// The meshes of the file, those without morph targets first.
Json meshes_of(const SkinnedFigure& figure, GlbBuffer& buffer) {
  Json still = Json::array(), meshes = Json::array();
  for (const SkinnedMesh& mesh : figure.meshes) {
    if (mesh.morphs.empty())
      still.push_back(primitive_of(mesh, buffer));
    else
      meshes.push_back(morphed_mesh(mesh, figure.morphs, buffer));
  }
  if (still.empty()) return meshes;
  const Json surface = {{"name", "surface"}, {"primitives", std::move(still)}};
  meshes.insert(meshes.begin(), surface);
  return meshes;
}

Json skin_of(const motion::JointTransforms& bind, GlbBuffer& buffer) {
  std::vector<float> inverse_binds;
  Json joints = Json::array();
  for (std::size_t j = 0; j < bind.positions.size(); ++j) {
    const Eigen::Affine3d world = Eigen::Translation3d(bind.positions[j]) * bind.rotations[j];
    const Eigen::Matrix4f matrix = world.inverse(Eigen::Isometry).matrix().cast<float>();
    inverse_binds.insert(inverse_binds.end(), matrix.data(), matrix.data() + matrix.size());
    joints.push_back(j);
  }
  return {{"inverseBindMatrices", add(buffer, inverse_binds, GlbElement::mat4)},
          {"joints", joints}};
}

Json joint_nodes(const SkinnedFigure& figure) {
  Json nodes = Json::array();
  for (std::size_t j = 0; j < figure.joints.size(); ++j) {
    const motion::Vec3& at = figure.bind.positions[j];
    const motion::Quat& turned = figure.bind.rotations[j];
    nodes.push_back({{"name", figure.joints[j]},
                     {"translation", {at.x(), at.y(), at.z()}},
                     {"rotation", {turned.x(), turned.y(), turned.z(), turned.w()}},
                     {"extras", {{"body_joint", figure.body_joints[j]}}}});
  }
  return nodes;
}

/// Pictures of the document, each written once.
class Pictures {
 public:
  Pictures(const SkinnedFigure& figure, Json& document, GlbBuffer& buffer)
      : figure_(figure), document_(document), buffer_(buffer) {}

  Json entry(int texture, render::TextureUse use) {
    const auto [known, is_new] = written_.try_emplace({texture, use}, written_.size());
    if (is_new) {
      const std::string png =
          render::texture_png(*figure_.textures[static_cast<std::size_t>(texture)], use);
      document_["images"].push_back(
          {{"bufferView", motion::add_file(buffer_, png)}, {"mimeType", "image/png"}});
      document_["textures"].push_back({{"source", known->second}});
    }
    return {{"index", known->second}};
  }

 private:
  const SkinnedFigure& figure_;
  Json& document_;
  GlbBuffer& buffer_;
  std::map<std::pair<int, render::TextureUse>, std::size_t> written_;
};

Json material_of(const render::Material& material, Pictures& pictures) {
  Json surface = {
      {"baseColorFactor", {material.albedo.x(), material.albedo.y(), material.albedo.z(), 1.0}},
      {"metallicFactor", 0.0},
      {"roughnessFactor", material.roughness}};
  if (material.texture >= 0)
    surface["baseColorTexture"] = pictures.entry(material.texture, render::TextureUse::colour);
  Json made = {{"pbrMetallicRoughness", surface}, {"doubleSided", true}};
  if (material.normal_map >= 0) {
    made["normalTexture"] = pictures.entry(material.normal_map, render::TextureUse::numbers);
    made["normalTexture"]["scale"] = material.normal_scale;
  }
  return made;
}

}  // namespace

std::string skinned_glb(const SkinnedFigure& figure) {
  GlbBuffer buffer;
  Json document;
  document["asset"] = {{"version", "2.0"}, {"generator", "mien"}};
  document["scene"] = 0;
  Json nodes = joint_nodes(figure), shown = Json::array(), meshes = meshes_of(figure, buffer);
  for (std::size_t mesh = 0; mesh < meshes.size(); ++mesh)
    nodes.push_back({{"name", meshes[mesh]["name"]}, {"mesh", mesh}, {"skin", 0}});
  for (std::size_t node = 0; node < nodes.size(); ++node) shown.push_back(node);
  Pictures pictures(figure, document, buffer);
  Json materials = Json::array();
  for (const render::Material& material : figure.materials)
    materials.push_back(material_of(material, pictures));
  document["scenes"] = Json::array({{{"nodes", shown}}});
  document["nodes"] = std::move(nodes);
  document["meshes"] = std::move(meshes);
  document["skins"] = Json::array({skin_of(figure.bind, buffer)});
  document["materials"] = std::move(materials);
  return motion::glb_of(std::move(document), buffer);
}

}  // namespace mien::scenes
