#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "motion/formats/gltf/glb_buffer.h"
#include "motion/formats/gltf/gltf.h"
#include "motion/formats/gltf/gltf_track.h"
#include "motion/math/rotation.h"
#include "motion/skeleton/skeleton.h"

namespace mien::motion {

namespace {

/// A mesh that shows the bones of a skeleton at rest, each vertex bound to one joint.
struct StickMesh {
  std::vector<Vec3> positions;                          ///< world space, in the skeleton's unit
  std::vector<int> joints;                              ///< one a vertex
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< counter-clockwise from outside
};

void add_bone(const Vec3& head, const Vec3& bone, int joint, StickMesh& mesh) {
  const double length = bone.norm();
  if (!(length > 1e-9)) return;
  const Vec3 along = bone / length;
  const Vec3 u = along.unitOrthogonal();
  const Vec3 v = along.cross(u);
  const Vec3 middle = head + 0.15 * bone;
  const double radius = 0.08 * length;
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (const Vec3& position :
       {head, Vec3(head + bone), Vec3(middle + radius * u), Vec3(middle + radius * v),
        Vec3(middle - radius * u), Vec3(middle - radius * v)}) {
    mesh.positions.push_back(position);
    mesh.joints.push_back(joint);
  }
  for (std::uint32_t side = 0; side < 4; ++side) {
    const std::uint32_t one = first + 2 + side;
    const std::uint32_t next = first + 2 + (side + 1) % 4;
    mesh.triangles.push_back({first + 1, one, next});
    mesh.triangles.push_back({first, next, one});
  }
}

/// Positions of the joints when no joint is turned and the root stands at its own offset.
std::vector<Vec3> bind_positions(const Skeleton& skeleton) {
  std::vector<Vec3> positions;
  positions.reserve(skeleton.joints.size());
  for (const Joint& joint : skeleton.joints) {
    const bool is_root = joint.parent < 0;
    positions.push_back(is_root ? joint.offset
                                : positions[static_cast<size_t>(joint.parent)] + joint.offset);
  }
  return positions;
}

/// An octahedron from every joint to each child and to its tip, bound to that joint. A skeleton
/// without any bone gets one a tenth of the unit long on its root.
StickMesh stick_mesh(const Skeleton& skeleton) {
  const std::vector<Vec3> positions = bind_positions(skeleton);
  StickMesh mesh;
  for (int j = 0; j < skeleton.size(); ++j) {
    const Joint& joint = skeleton.joints[static_cast<size_t>(j)];
    if (joint.parent >= 0) {
      add_bone(positions[static_cast<size_t>(joint.parent)], joint.offset, joint.parent, mesh);
    }
    if (joint.tip) add_bone(positions[static_cast<size_t>(j)], *joint.tip, j, mesh);
  }
  if (mesh.positions.empty()) add_bone(positions.front(), {0.0, 0.1, 0.0}, 0, mesh);
  return mesh;
}

using Json = nlohmann::ordered_json;

void append(std::vector<float>& numbers, const Vec3& v) {
  for (const double coordinate : v) numbers.push_back(static_cast<float>(coordinate));
}

Json json_of(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

/// The joints' nodes have the joints' indices; nodes of tips follow.
Json nodes_of(const Skeleton& skeleton) {
  Json nodes = Json::array();
  const auto children = children_of(skeleton);
  for (size_t j = 0; j < skeleton.joints.size(); ++j) {
    const Joint& joint = skeleton.joints[j];
    Json node = {{"name", joint.name}, {"translation", json_of(joint.offset)}};
    if (!children[j].empty()) node["children"] = children[j];
    nodes.push_back(std::move(node));
  }
  for (size_t j = 0; j < skeleton.joints.size(); ++j) {
    const Joint& joint = skeleton.joints[j];
    if (!joint.tip) continue;
    nodes[j]["children"].push_back(nodes.size());
    nodes.push_back({{"name", joint.name + "_end"}, {"translation", json_of(*joint.tip)}});
  }
  return nodes;
}

bool offset_changes(const Recording& recording, size_t joint) {
  return std::any_of(recording.poses.begin(), recording.poses.end(), [&](const Pose& pose) {
    return !pose.offsets.empty() && pose.offsets[joint] != recording.skeleton.joints[joint].offset;
  });
}

std::vector<float> translation_keys(const Recording& recording, size_t joint) {
  std::vector<float> keys;
  for (const Pose& pose : recording.poses) {
    const Vec3& offset =
        pose.offsets.empty() ? recording.skeleton.joints[joint].offset : pose.offsets[joint];
    append(keys, joint == 0 ? pose.root_position : offset);
  }
  return keys;
}

/// Each quaternion in the hemisphere of the one before, so that importers which interpolate the
/// four numbers go the short way.
std::vector<float> rotation_keys(const Recording& recording, size_t joint) {
  std::vector<float> keys;
  Quat before = Quat::Identity();
  for (const Pose& pose : recording.poses) {
    before = in_hemisphere_of(before, pose.rotations[joint]);
    for (const double number : before.coeffs()) keys.push_back(static_cast<float>(number));
  }
  return keys;
}

std::vector<float> key_times(const Recording& recording) {
  std::vector<float> times;
  for (int frame = 0; frame < recording.frame_count(); ++frame) {
    times.push_back(static_cast<float>(frame / recording.frames_per_second));
  }
  return times;
}

/// Whether a reader finds the frame rate in the times of the keys: there are two or more, at ten or
/// more whole frames per second. Times are 32-bit floats, which other rates would be lost in.
bool is_rate_in_keys(const Recording& recording) {
  const double rate = recording.frames_per_second;
  return recording.frame_count() > 1 && rate >= 10.0 && rate == std::round(rate);
}

Json animation_of(const Recording& recording, GlbBuffer& binary) {
  const std::vector<float> times = key_times(recording);
  const size_t input = add_bounded(binary, times, GlbElement::scalar);
  Json channels = Json::array();
  Json samplers = Json::array();
  const auto add_track = [&](size_t joint, const char* path, size_t output) {
    channels.push_back(
        {{"sampler", samplers.size()}, {"target", {{"node", joint}, {"path", path}}}});
    samplers.push_back({{"input", input}, {"output", output}});
  };
  for (size_t j = 0; j < recording.skeleton.joints.size(); ++j) {
    if (j == 0 || offset_changes(recording, j)) {
      add_track(j, "translation", add(binary, translation_keys(recording, j), GlbElement::vec3));
    }
    add_track(j, "rotation", add(binary, rotation_keys(recording, j), GlbElement::vec4));
  }
  Json animation = {{"name", recording.name}, {"channels", channels}, {"samplers", samplers}};
  if (!is_rate_in_keys(recording)) {
    animation["extras"] = {{gltf_rate_key, recording.frames_per_second}};
  }
  return animation;
}

Json mesh_of(const Skeleton& skeleton, GlbBuffer& binary) {
  const StickMesh mesh = stick_mesh(skeleton);
  std::vector<float> positions;
  for (const Vec3& position : mesh.positions) append(positions, position);
  std::vector<std::uint16_t> joints;
  std::vector<float> weights;
  for (const int joint : mesh.joints) {
    joints.insert(joints.end(), {static_cast<std::uint16_t>(joint), 0, 0, 0});
    weights.insert(weights.end(), {1.0f, 0.0f, 0.0f, 0.0f});
  }
  std::vector<std::uint32_t> indices;
  for (const auto& triangle : mesh.triangles) {
    indices.insert(indices.end(), triangle.begin(), triangle.end());
  }
  const size_t position = add_bounded(binary, positions, GlbElement::vec3, GlbUse::vertices);
  Json attributes = {{"POSITION", position}};
  attributes["JOINTS_0"] = add(binary, joints, GlbElement::vec4, GlbUse::vertices);
  attributes["WEIGHTS_0"] = add(binary, weights, GlbElement::vec4, GlbUse::vertices);
  const size_t triangles = add(binary, indices, GlbElement::scalar, GlbUse::indices);
  const Json primitive = {{"attributes", attributes}, {"indices", triangles}};
  return {{"name", "bones"}, {"primitives", Json::array({primitive})}};
}

Json skin_of(const Skeleton& skeleton, GlbBuffer& binary) {
  std::vector<float> inverse_binds;
  Json joints = Json::array();
  for (const Vec3& position : bind_positions(skeleton)) {
    joints.push_back(joints.size());
    Eigen::Matrix4f matrix = Eigen::Matrix4f::Identity();
    matrix.topRightCorner<3, 1>() = -position.cast<float>();
    inverse_binds.insert(inverse_binds.end(), matrix.data(), matrix.data() + matrix.size());
  }
  return {{"inverseBindMatrices", add(binary, inverse_binds, GlbElement::mat4)},
          {"skeleton", 0},
          {"joints", joints}};
}

Json document_of(const Recording& recording, GlbBuffer& binary) {
  const Skeleton& skeleton = recording.skeleton;
  Json nodes = nodes_of(skeleton);
  const size_t mesh_node = nodes.size();
  nodes.push_back({{"name", "bones"}, {"mesh", 0}, {"skin", 0}});
  Json document;
  document["asset"] = {{"version", "2.0"}, {"generator", "mien"}};
  document["scene"] = 0;
  document["scenes"] = Json::array({{{"nodes", {0, mesh_node}}}});
  document["nodes"] = std::move(nodes);
  document["meshes"] = Json::array({mesh_of(skeleton, binary)});
  document["skins"] = Json::array({skin_of(skeleton, binary)});
  document["animations"] = Json::array({animation_of(recording, binary)});
  return document;
}

}  // namespace

std::string to_glb(const Recording& recording) {
  GlbBuffer binary;
  Json document = document_of(recording, binary);
  return glb_of(std::move(document), binary);
}

}  // namespace mien::motion
