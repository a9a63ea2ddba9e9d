#include <algorithm>
#include <cstdint>
#include <utility>

#include <nlohmann/json.hpp>

#include "motion/formats/glb_buffer.h"
#include "motion/formats/gltf.h"
#include "motion/formats/gltf_stick_mesh.h"
#include "motion/formats/gltf_track.h"
#include "motion/math/rotation.h"
#include "motion/text/result_file.h"

namespace mien::motion {

namespace {

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
  if (recording.frames_per_second < 10.0) {
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

void write_glb(const Recording& recording, const std::filesystem::path& path) {
  write_result(path, to_glb(recording));
}

}  // namespace mien::motion
