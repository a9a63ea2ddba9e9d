#include <algorithm>
#include <cstdint>
#include <cstring>

#include <nlohmann/json.hpp>

#include "motion/formats/gltf.h"
#include "motion/formats/gltf_stick_mesh.h"
#include "motion/math/rotation.h"
#include "motion/text/file_contents.h"

namespace mien::motion {

namespace {

using Json = nlohmann::ordered_json;

enum ComponentType { unsigned_short = 5123, unsigned_int = 5125, float32 = 5126 };
enum class Target { none = 0, vertices = 34962, indices = 34963 };

/// The binary chunk and what the JSON says of it.
struct BinaryPart {
  std::string bytes;
  Json views = Json::array();
  Json accessors = Json::array();
};

struct ElementType {
  const char* name;  ///< "VEC3"
  size_t components;
};

constexpr ElementType scalar = {"SCALAR", 1};
constexpr ElementType vec3 = {"VEC3", 3};
constexpr ElementType vec4 = {"VEC4", 4};
constexpr ElementType mat4 = {"MAT4", 16};

/// Adds the numbers with a view and an accessor of their own; returns the accessor's index.
template <typename T>
size_t add(BinaryPart& binary, const std::vector<T>& numbers, ComponentType component,
           ElementType element, Target target = Target::none) {
  const size_t size = numbers.size() * sizeof(T);
  Json view = {{"buffer", 0}, {"byteOffset", binary.bytes.size()}, {"byteLength", size}};
  if (target != Target::none) view["target"] = static_cast<int>(target);
  binary.views.push_back(std::move(view));
  binary.accessors.push_back({{"bufferView", binary.views.size() - 1},
                              {"componentType", static_cast<int>(component)},
                              {"count", numbers.size() / element.components},
                              {"type", element.name}});
  binary.bytes.append(reinterpret_cast<const char*>(numbers.data()), size);
  binary.bytes.resize((binary.bytes.size() + 3) / 4 * 4, '\0');
  return binary.accessors.size() - 1;
}

/// States least and most of each component, which glTF asks for of key times and positions.
void state_bounds(BinaryPart& binary, size_t accessor, const std::vector<float>& numbers,
                  size_t components) {
  Json least = Json::array();
  Json most = Json::array();
  for (size_t c = 0; c < components; ++c) {
    float low = numbers[c];
    float high = numbers[c];
    for (size_t i = c; i < numbers.size(); i += components) {
      low = std::min(low, numbers[i]);
      high = std::max(high, numbers[i]);
    }
    least.push_back(low);
    most.push_back(high);
  }
  binary.accessors[accessor]["min"] = std::move(least);
  binary.accessors[accessor]["max"] = std::move(most);
}

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

Json animation_of(const Recording& recording, BinaryPart& binary) {
  const std::vector<float> times = key_times(recording);
  const size_t input = add(binary, times, float32, scalar);
  state_bounds(binary, input, times, 1);
  Json channels = Json::array();
  Json samplers = Json::array();
  const auto add_track = [&](size_t joint, const char* path, size_t output) {
    channels.push_back(
        {{"sampler", samplers.size()}, {"target", {{"node", joint}, {"path", path}}}});
    samplers.push_back({{"input", input}, {"output", output}});
  };
  for (size_t j = 0; j < recording.skeleton.joints.size(); ++j) {
    if (j == 0 || offset_changes(recording, j)) {
      add_track(j, "translation", add(binary, translation_keys(recording, j), float32, vec3));
    }
    add_track(j, "rotation", add(binary, rotation_keys(recording, j), float32, vec4));
  }
  return {{"name", recording.name}, {"channels", channels}, {"samplers", samplers}};
}

Json mesh_of(const Skeleton& skeleton, BinaryPart& binary) {
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
  const size_t position = add(binary, positions, float32, vec3, Target::vertices);
  state_bounds(binary, position, positions, 3);
  Json attributes = {{"POSITION", position}};
  attributes["JOINTS_0"] = add(binary, joints, unsigned_short, vec4, Target::vertices);
  attributes["WEIGHTS_0"] = add(binary, weights, float32, vec4, Target::vertices);
  const size_t triangles = add(binary, indices, unsigned_int, scalar, Target::indices);
  const Json primitive = {{"attributes", attributes}, {"indices", triangles}};
  return {{"name", "bones"}, {"primitives", Json::array({primitive})}};
}

Json skin_of(const Skeleton& skeleton, BinaryPart& binary) {
  std::vector<float> inverse_binds;
  Json joints = Json::array();
  for (const Vec3& position : bind_positions(skeleton)) {
    joints.push_back(joints.size());
    Eigen::Matrix4f matrix = Eigen::Matrix4f::Identity();
    matrix.topRightCorner<3, 1>() = -position.cast<float>();
    inverse_binds.insert(inverse_binds.end(), matrix.data(), matrix.data() + matrix.size());
  }
  return {{"inverseBindMatrices", add(binary, inverse_binds, float32, mat4)},
          {"skeleton", 0},
          {"joints", joints}};
}

Json document_of(const Recording& recording, BinaryPart& binary) {
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
  document["accessors"] = std::move(binary.accessors);
  document["bufferViews"] = std::move(binary.views);
  document["buffers"] = Json::array({{{"byteLength", binary.bytes.size()}}});
  return document;
}

void append_word(std::string& bytes, size_t word) {
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(word >> shift & 0xFF);
}

void append_chunk(std::string& bytes, const char* type, const std::string& chunk, char padding) {
  const size_t padded = (chunk.size() + 3) / 4 * 4;
  append_word(bytes, padded);
  bytes.append(type, 4).append(chunk).append(padded - chunk.size(), padding);
}

}  // namespace

std::string to_glb(const Recording& recording) {
  BinaryPart binary;
  const Json document = document_of(recording, binary);
  std::string chunks;
  // Names may hold bytes that are no UTF-8.
  append_chunk(chunks, "JSON", document.dump(-1, ' ', false, Json::error_handler_t::replace), ' ');
  append_chunk(chunks, "BIN\0", binary.bytes, '\0');
  std::string file = "glTF";
  append_word(file, 2);
  append_word(file, 12 + chunks.size());
  return file + chunks;
}

void write_glb(const Recording& recording, const std::filesystem::path& path) {
  write_contents(path, to_glb(recording));
}

}  // namespace mien::motion
