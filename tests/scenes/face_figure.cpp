#include "scenes/face_figure.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "motion/formats/gltf/glb_buffer.h"
#include "motion/skeleton/body.h"
#include "scenes/face_surfaces.h"
#include "scenes/mannequin/mannequin.h"
#include "scenes/skinned_gltf.h"

namespace mien::test {

namespace {

using Json = nlohmann::ordered_json;
using motion::GlbBuffer;
using motion::GlbElement;
using motion::Quat;
using motion::Vec3;

std::vector<Vec3> points_of(const FaceSurface& surface, const FaceShape& shape) {
  std::vector<Vec3> points;
  for (int r = 0; r <= surface.rows; ++r)
    for (int c = 0; c <= surface.columns; ++c)
      points.push_back(surface.point(1.0 * r / surface.rows, 1.0 * c / surface.columns, shape));
  return points;
}

std::vector<std::uint32_t> corners_of(const FaceSurface& surface) {
  std::vector<std::uint32_t> corners;
  const auto vertex = [&](int r, int c) {
    return static_cast<std::uint32_t>(r * (surface.columns + 1) + c);
  };
  for (int r = 0; r < surface.rows; ++r) {
    for (int c = 0; c < surface.columns; ++c) {
      const auto a = vertex(r, c), b = vertex(r, c + 1), d = vertex(r + 1, c);
      corners.insert(corners.end(), {a, b, d, b, vertex(r + 1, c + 1), d});
    }
  }
  return corners;
}

std::vector<float> floats_of(const std::vector<Vec3>& vectors) {
  std::vector<float> numbers;
  for (const Vec3& v : vectors)
    for (const double coordinate : v) numbers.push_back(static_cast<float>(coordinate));
  return numbers;
}

/// Adds numbers without an accessor of their own; returns their buffer view.
std::size_t add_view(GlbBuffer& buffer, const auto& numbers, GlbElement element) {
  const std::size_t accessor = add(buffer, numbers, element);
  const std::size_t view = buffer.accessors[accessor]["bufferView"];
  buffer.accessors.erase(accessor);
  return view;
}

/// The moved vertices of a target as a sparse accessor.
std::size_t add_sparse(GlbBuffer& buffer, const std::vector<Vec3>& from,
                       const std::vector<Vec3>& to) {
  std::vector<std::uint32_t> indices;
  std::vector<Vec3> moves;
  for (std::size_t v = 0; v < from.size(); ++v) {
    if (from[v] == to[v] && !(v + 1 == from.size() && indices.empty())) continue;
    indices.push_back(static_cast<std::uint32_t>(v));
    moves.emplace_back(to[v] - from[v]);
  }
  const std::size_t index_view = add_view(buffer, indices, GlbElement::scalar);
  const std::size_t value_view = add_view(buffer, floats_of(moves), GlbElement::vec3);
  buffer.accessors.push_back({{"componentType", 5126},
                              {"count", from.size()},
                              {"type", "VEC3"},
                              {"sparse",
                               {{"count", indices.size()},
                                {"indices", {{"bufferView", index_view}, {"componentType", 5125}}},
                                {"values", {{"bufferView", value_view}}}}}});
  return buffer.accessors.size() - 1;
}

void add_joints(GlbBuffer& buffer, const std::vector<std::vector<scenes::Influence>>& influences,
                Json& attributes) {
  std::vector<std::uint16_t> joints;
  std::vector<float> weights;
  for (const std::vector<scenes::Influence>& all : influences) {
    float sum = 0.0f;
    for (std::size_t k = 0; k < 4; ++k) sum += k < all.size() ? all[k].weight : 0.0f;
    for (std::size_t k = 0; k < 4; ++k) {
      joints.push_back(k < all.size() ? static_cast<std::uint16_t>(all[k].joint) : 0);
      weights.push_back(k < all.size() ? all[k].weight / sum : 0.0f);
    }
  }
  attributes["JOINTS_0"] = add(buffer, joints, GlbElement::vec4);
  attributes["WEIGHTS_0"] = add(buffer, weights, GlbElement::vec4);
}

constexpr FaceBone face_bones[] = {FaceBone::jaw, FaceBone::left_eye, FaceBone::right_eye};
constexpr const char* face_bone_names[] = {"Jaw", "LeftEye", "RightEye"};

/// Those of jaw and eyes follow the joints of the body.
int joint_of(FaceBone bone) {
  return bone == FaceBone::head ? static_cast<int>(motion::Head)
                                : motion::body_joint_count - 1 + static_cast<int>(bone);
}

std::vector<scenes::Influence> influences_at(const FaceSurface& surface, const Vec3& at,
                                             FaceFormat format) {
  if (format != FaceFormat::joints) return {{motion::Head, 1.0f}};
  if (surface.bone != FaceBone::head) return {{joint_of(surface.bone), 1.0f}};
  const auto share = surface.material == skin ? static_cast<float>(jaw_share(at)) : 0.0f;
  if (share == 0.0f) return {{motion::Head, 1.0f}};
  return {{motion::Head, 1.0f - share}, {joint_of(FaceBone::jaw), share}};
}

Json targets_of(const FaceSurface& surface, const std::vector<Vec3>& points, GlbBuffer& buffer) {
  Json targets = Json::array();
  for (std::size_t t = 0; t < face_targets.size(); ++t) {
    FaceShape shape{};
    shape[t] = 1.0;
    targets.push_back({{"POSITION", add_sparse(buffer, points, points_of(surface, shape))}});
  }
  return targets;
}

Json face_primitive(const FaceSurface& surface, const Vec3& head, FaceFormat format,
                    GlbBuffer& buffer) {
  std::vector<Vec3> points = points_of(surface, {});
  std::vector<std::vector<scenes::Influence>> influences;
  for (const Vec3& at : points) influences.push_back(influences_at(surface, at, format));
  Json targets = format == FaceFormat::joints ? Json() : targets_of(surface, points, buffer);
  for (Vec3& point : points) point += head;
  Json attributes = {{"POSITION", add(buffer, floats_of(points), GlbElement::vec3)}};
  add_joints(buffer, influences, attributes);
  Json primitive = {{"attributes", attributes},
                    {"indices", add(buffer, corners_of(surface), GlbElement::scalar)},
                    {"material", surface.material}};
  if (!targets.is_null()) primitive["targets"] = std::move(targets);
  return primitive;
}

/// Adds the joints of jaw and eyes below the head.
void add_face_bones(motion::Skeleton& body, motion::JointTransforms& bind, const Vec3& middle) {
  const Vec3 head = bind.positions[motion::Head];
  for (std::size_t k = 0; k < std::size(face_bones); ++k) {
    const Vec3 at = middle + place_of(face_bones[k]);
    body.joints.push_back({face_bone_names[k], motion::Head, at - head, std::nullopt});
    bind.positions.push_back(at);
    bind.rotations.push_back(bind.rotations[motion::Head]);
  }
}

float weight_of_head(const std::vector<scenes::Influence>& influences) {
  float weight = 0.0f;
  for (const scenes::Influence& one : influences)
    if (one.joint == motion::Head) weight += one.weight;
  return weight;
}

/// The mannequin, its head and chin shrunk into those of the face.
scenes::SkinnedMesh small_headed(const scenes::Mannequin& mannequin, const Vec3& head) {
  scenes::SkinnedMesh mesh = mannequin.mesh;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const double share = static_cast<double>(weight_of_head(mesh.influences[v]));
    mesh.positions[v] += 0.4 * share * (head - mesh.positions[v]);
  }
  return mesh;
}

Json body_primitive(const scenes::SkinnedMesh& mesh, GlbBuffer& buffer) {
  std::vector<std::uint32_t> corners;
  for (const auto& triangle : mesh.triangles)
    for (const int corner : triangle) corners.push_back(static_cast<std::uint32_t>(corner));
  Json attributes = {{"POSITION", add(buffer, floats_of(mesh.positions), GlbElement::vec3)},
                     {"NORMAL", add(buffer, floats_of(mesh.normals), GlbElement::vec3)}};
  add_joints(buffer, mesh.influences, attributes);
  return {{"attributes", attributes},
          {"indices", add(buffer, corners, GlbElement::scalar)},
          {"material", cloth}};
}

Json nodes_of(const motion::Skeleton& body, const motion::JointTransforms& bind) {
  Json nodes = Json::array();
  for (std::size_t j = 0; j < body.joints.size(); ++j) {
    const int parent = body.joints[j].parent;
    const auto above = static_cast<std::size_t>(std::max(parent, 0));
    const Quat undo = parent < 0 ? Quat::Identity() : bind.rotations[above].conjugate();
    const Vec3 from = parent < 0 ? Vec3(Vec3::Zero()) : bind.positions[above];
    const Vec3 at = undo * (bind.positions[j] - from);
    const Quat turn = undo * bind.rotations[j];
    Json node = {{"name", body.joints[j].name},
                 {"translation", {at.x(), at.y(), at.z()}},
                 {"rotation", {turn.x(), turn.y(), turn.z(), turn.w()}}};
    for (std::size_t child = 1; child < body.joints.size(); ++child)
      if (body.joints[child].parent == static_cast<int>(j)) node["children"].push_back(child);
    nodes.push_back(node);
  }
  return nodes;
}

Json skin_of_body(const motion::JointTransforms& bind, GlbBuffer& buffer) {
  std::vector<float> inverses;
  Json joints = Json::array();
  for (std::size_t j = 0; j < bind.positions.size(); ++j) {
    const Eigen::Affine3d world = Eigen::Translation3d(bind.positions[j]) * bind.rotations[j];
    const Eigen::Matrix4f matrix = world.inverse(Eigen::Isometry).matrix().cast<float>();
    inverses.insert(inverses.end(), matrix.data(), matrix.data() + matrix.size());
    joints.push_back(j);
  }
  return {{"inverseBindMatrices", add(buffer, inverses, GlbElement::mat4)}, {"joints", joints}};
}

Json material_of(double red, double green, double blue, double roughness) {
  return {{"pbrMetallicRoughness",
           {{"baseColorFactor", {red, green, blue, 1.0}}, {"roughnessFactor", roughness}}},
          {"doubleSided", true}};
}

Json bound(std::initializer_list<std::pair<int, double>> binds, std::size_t node) {
  Json expression = {{"morphTargetBinds", Json::array()}};
  for (const auto& [target, weight] : binds)
    expression["morphTargetBinds"].push_back(
        {{"node", node}, {"index", target}, {"weight", weight}});
  return expression;
}

Json vrm_of(std::size_t face_node) {
  Json vrm = {{"specVersion", "1.0"}};
  const std::vector<std::string> names = vrm_names();
  for (std::size_t j = 0; j < names.size(); ++j)
    vrm["humanoid"]["humanBones"][names[j]] = {{"node", j}};
  vrm["expressions"]["preset"] = {
      {"happy", bound({{smile_left, 1.0}, {smile_right, 1.0}}, face_node)},
      {"sad", bound({{frown_left, 1.0}, {frown_right, 1.0}, {brow_inner_up, 1.0}}, face_node)},
      {"angry",
       bound({{frown_left, 0.6}, {frown_right, 0.6}, {brow_down_left, 1.0}, {brow_down_right, 1.0}},
             face_node)},
      {"surprised", bound({{jaw_open, 0.7}, {brow_inner_up, 1.0}}, face_node)},
      {"blink", bound({{blink_left, 1.0}, {blink_right, 1.0}}, face_node)}};
  return {{"VRMC_vrm", vrm}};
}

}  // namespace

std::string face_figure_glb(FaceFormat format) {
  motion::Skeleton body = motion::standard_body();
  const scenes::Mannequin mannequin = scenes::make_mannequin(
      body, {}, scenes::colours_of(scenes::Role::neutral), scenes::MeshDetail::draft);
  GlbBuffer buffer;
  motion::JointTransforms bind = mannequin.bind;
  const Vec3 head = mannequin.bind.positions[motion::Head] + Vec3(0.0, 0.095, 0.015);
  Json faces = Json::array(), names = Json::array();
  for (const FaceSurface& surface : face_surfaces())
    faces.push_back(face_primitive(surface, head, format, buffer));
  for (const std::string_view name : face_targets) names.push_back(std::string(name));
  if (format == FaceFormat::joints) add_face_bones(body, bind, head);
  Json nodes = nodes_of(body, bind);
  const std::size_t face_node = nodes.size();
  nodes.push_back({{"name", "face"}, {"mesh", 0}, {"skin", 0}});
  nodes.push_back({{"name", "body"}, {"mesh", 1}, {"skin", 0}});
  Json document = {
      {"asset", {{"version", "2.0"}}},
      {"scene", 0},
      {"scenes", {{{"nodes", {0, face_node, face_node + 1}}}}},
      {"nodes", nodes},
      {"meshes",
       {{{"name", "face"}, {"primitives", faces}, {"extras", {{"targetNames", names}}}},
        {{"name", "body"},
         {"primitives", {body_primitive(small_headed(mannequin, head), buffer)}}}}},
      {"skins", {skin_of_body(bind, buffer)}},
      {"materials",
       {material_of(0.2, 0.25, 0.35, 0.7), material_of(0.62, 0.4, 0.3, 0.5),
        material_of(0.85, 0.85, 0.83, 0.2), material_of(0.12, 0.22, 0.35, 0.2),
        material_of(0.02, 0.015, 0.015, 0.4), material_of(0.5, 0.16, 0.15, 0.4),
        material_of(0.06, 0.04, 0.03, 0.6)}}};
  if (format == FaceFormat::vrm) document["extensions"] = vrm_of(face_node);
  return motion::glb_of(std::move(document), buffer);
}

}  // namespace mien::test
