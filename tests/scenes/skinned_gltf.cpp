#include "skinned_gltf.h"

#include <cctype>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "motion/math/rotation.h"
#include "motion/skeleton/hand.h"

namespace mien::test {

namespace {

using motion::Quat;
using motion::Vec3;
using nlohmann::json;

std::string base64(const std::vector<unsigned char>& bytes) {
  constexpr char letters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    for (size_t k = 0; k < 3; ++k) three = three << 8 | (i + k < bytes.size() ? bytes[i + k] : 0u);
    for (int k = 3; k >= 0; --k) text += letters[three >> (6 * k) & 63];
  }
  for (size_t k = 0; k < (3 - bytes.size() % 3) % 3; ++k) text[text.size() - 1 - k] = '=';
  return text;
}

/// Appends numbers to the buffer as an accessor of its own.
template <typename Number>
int add_accessor(SkinnedGltf& file, const std::vector<Number>& numbers, int component_type,
                 const std::string& type, size_t components) {
  while (file.buffer.size() % 4 != 0) file.buffer.push_back(0);
  const size_t offset = file.buffer.size();
  file.buffer.resize(offset + numbers.size() * sizeof(Number));
  std::memcpy(file.buffer.data() + offset, numbers.data(), numbers.size() * sizeof(Number));
  json& views = file.json["bufferViews"];
  views.push_back(
      {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", numbers.size() * sizeof(Number)}});
  json& accessors = file.json["accessors"];
  accessors.push_back({{"bufferView", views.size() - 1},
                       {"componentType", component_type},
                       {"count", numbers.size() / components},
                       {"type", type}});
  return static_cast<int>(accessors.size()) - 1;
}

constexpr int is_float = 5126;
constexpr int is_byte = 5121;
constexpr int is_short = 5123;

struct Boxes {
  std::vector<float> positions;
  std::vector<float> uv;
  std::vector<std::uint8_t> joints;
  std::vector<float> weights;
  std::vector<std::uint16_t> corners;
};

/// A box from `from` to `to`, a few centimetres thick, or as thick as a finger.
void add_box(Boxes& boxes, const Vec3& from, const Vec3& to, int joint, double unit) {
  const Vec3 along = to - from;
  const double half_thickness = joint < motion::body_joint_count ? 0.02 : 0.007;
  const Vec3 side = along.unitOrthogonal() * half_thickness * unit;
  const Vec3 up = along.normalized().cross(side);
  const auto first = static_cast<std::uint16_t>(boxes.positions.size() / 3);
  for (int c = 0; c < 8; ++c) {
    const Vec3 point =
        (c & 4 ? to : from) + (c & 1 ? side : Vec3(-side)) + (c & 2 ? up : Vec3(-up));
    for (int k = 0; k < 3; ++k) boxes.positions.push_back(static_cast<float>(point[k]));
    boxes.uv.insert(boxes.uv.end(), {c & 1 ? 0.75f : 0.25f, 0.5f});
    boxes.joints.insert(boxes.joints.end(), {static_cast<std::uint8_t>(joint), 0, 0, 0});
    boxes.weights.insert(boxes.weights.end(), {1.0f, 0.0f, 0.0f, 0.0f});
  }
  for (const int c : {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                      2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5}) {
    boxes.corners.push_back(static_cast<std::uint16_t>(first + c));
  }
}

Vec3 end_of(const motion::Skeleton& body, const motion::JointTransforms& bind, size_t j) {
  for (size_t child = 1; child < body.joints.size(); ++child) {
    const bool is_child = body.joints[child].parent == static_cast<int>(j);
    if (is_child && body.joints[child].offset.norm() > 1e-6) return bind.positions[child];
  }
  return bind.positions[j] + bind.rotations[j] * body.joints[j].tip.value_or(Vec3(0, 0.05, 0));
}

void add_mesh(SkinnedGltf& file, const motion::Skeleton& body, const motion::JointTransforms& bind,
              double unit) {
  Boxes boxes;
  for (size_t j = 0; j < body.joints.size(); ++j) {
    add_box(boxes, bind.positions[j], end_of(body, bind, j), static_cast<int>(j), unit);
  }
  json primitive;
  primitive["attributes"] = {{"POSITION", add_accessor(file, boxes.positions, is_float, "VEC3", 3)},
                             {"TEXCOORD_0", add_accessor(file, boxes.uv, is_float, "VEC2", 2)},
                             {"JOINTS_0", add_accessor(file, boxes.joints, is_byte, "VEC4", 4)},
                             {"WEIGHTS_0", add_accessor(file, boxes.weights, is_float, "VEC4", 4)}};
  primitive["indices"] = add_accessor(file, boxes.corners, is_short, "SCALAR", 1);
  primitive["material"] = 0;
  file.json["meshes"] = {{{"primitives", {primitive}}}};
  file.json["materials"] = {
      {{"pbrMetallicRoughness",
        {{"baseColorFactor", {0.5, 1.0, 1.0, 1.0}}, {"baseColorTexture", {{"index", 0}}}}}}};
  file.json["textures"] = {{{"source", 0}}};
  file.json["images"] = {{{"uri", two_pixels()}}};
}

/// The body in the file's own unit and axes.
motion::Skeleton in_unit(motion::Skeleton body, double unit) {
  for (motion::Joint& joint : body.joints) {
    joint.offset *= unit;
    if (joint.tip) *joint.tip *= unit;
  }
  return body;
}

json numbers_of(const Vec3& v) { return {v.x(), v.y(), v.z()}; }
json numbers_of(const Quat& q) { return {q.x(), q.y(), q.z(), q.w()}; }

}  // namespace

SkinnedGltf skinned_gltf(const motion::Skeleton& metric_body, const SkinnedGltfOptions& options) {
  const motion::Skeleton body = in_unit(metric_body, options.unit);
  motion::Pose pose = options.bind;
  if (pose.rotations.empty()) pose.rotations.assign(body.joints.size(), Quat::Identity());
  pose.root_position = options.unit * Vec3(0.2, 1.0, -0.3);
  const Quat axes = options.z_up ? motion::exp(Vec3(motion::pi / 2, 0, 0)) : Quat::Identity();
  pose.root_position = axes * pose.root_position;
  pose.rotations[0] = axes * pose.rotations[0];
  const motion::JointTransforms bind = motion::world_transforms(body, pose);

  SkinnedGltf file;
  file.json["asset"] = {{"version", "2.0"}};
  json joints = json::array();
  std::vector<float> inverses;
  for (size_t j = 0; j < body.joints.size(); ++j) {
    json node;
    const motion::Joint& joint = body.joints[j];
    const bool turn = !options.posed_nodes && j > 0 && j % 3 == 0;
    node["translation"] = numbers_of(j == 0 ? pose.root_position : joint.offset);
    node["rotation"] = numbers_of(turn ? motion::exp(Vec3(0.3, 0.5, -0.4)) : pose.rotations[j]);
    if (!options.names.empty()) node["name"] = options.names[j];
    for (size_t child = 1; child < body.joints.size(); ++child) {
      if (body.joints[child].parent == static_cast<int>(j)) node["children"].push_back(child);
    }
    file.json["nodes"].push_back(node);
    joints.push_back(j);
    Eigen::Affine3d transform = Eigen::Affine3d::Identity();
    transform.translate(bind.positions[j]).rotate(bind.rotations[j]);
    const Eigen::Matrix4f inverse = transform.inverse().matrix().cast<float>();
    inverses.insert(inverses.end(), inverse.data(), inverse.data() + 16);
  }
  add_mesh(file, body, bind, options.unit);
  file.json["nodes"].push_back({{"mesh", 0}, {"skin", 0}});
  const int accessor = add_accessor(file, inverses, is_float, "MAT4", 16);
  file.json["skins"] = {{{"joints", joints}, {"inverseBindMatrices", accessor}}};
  pose.rotations[0] = axes.conjugate() * pose.rotations[0];
  pose.root_position = axes.conjugate() * pose.root_position / options.unit;
  file.bind = motion::world_transforms(metric_body, pose);
  return file;
}

void add_face(SkinnedGltf& file) {
  json& mesh = file.json["meshes"][0];
  json& primitive = mesh["primitives"][0];
  const json positions = primitive["attributes"]["POSITION"];
  primitive["targets"] = {{{"POSITION", positions}}, {{"POSITION", positions}}};
  mesh["extras"]["targetNames"] = {"one", "other"};
  const int times = add_accessor(file, std::vector<float>{0.0f, 1.0f}, is_float, "SCALAR", 1);
  const std::size_t node = file.json["nodes"].size() - 1;
  const auto animate = [&](const char* name, const std::vector<float>& weights) {
    const int output = add_accessor(file, weights, is_float, "SCALAR", 1);
    file.json["animations"].push_back(
        {{"name", name},
         {"samplers", {{{"input", times}, {"output", output}}}},
         {"channels", {{{"sampler", 0}, {"target", {{"node", node}, {"path", "weights"}}}}}}});
  };
  animate("Rise", {0.0f, 0.0f, 1.0f, 0.0f});
  animate("Fall", {1.0f, 0.0f, 0.0f, 0.0f});
}

std::string SkinnedGltf::text() const {
  nlohmann::json whole = json;
  whole["buffers"] = {{{"byteLength", buffer.size()},
                       {"uri", "data:application/octet-stream;base64," + base64(buffer)}}};
  return whole.dump();
}

std::vector<std::string> mixamo_names() {
  std::vector<std::string> names = {
      "Hips",      "Spine",       "Spine1",      "Neck",          "Head",        "LeftShoulder",
      "LeftArm",   "LeftForeArm", "LeftHand",    "RightShoulder", "RightArm",    "RightForeArm",
      "RightHand", "LeftUpLeg",   "LeftLeg",     "LeftFoot",      "LeftToeBase", "RightUpLeg",
      "RightLeg",  "RightFoot",   "RightToeBase"};
  for (std::string& name : names) name.insert(0, "mixamorig:");
  return names;
}

std::vector<std::string> vrm_names() {
  return {"hips",          "spine",         "chest",         "neck",          "head",
          "leftShoulder",  "leftUpperArm",  "leftLowerArm",  "leftHand",      "rightShoulder",
          "rightUpperArm", "rightLowerArm", "rightHand",     "leftUpperLeg",  "leftLowerLeg",
          "leftFoot",      "leftToes",      "rightUpperLeg", "rightLowerLeg", "rightFoot",
          "rightToes"};
}

std::vector<std::string> with_finger_names(std::vector<std::string> body, FingerNaming naming) {
  constexpr std::string_view fingers[] = {"Thumb", "Index", "Middle", "Ring", "Little"};
  constexpr std::string_view vrm_segments[] = {"Proximal", "Intermediate", "Distal"};
  for (int joint = 0; joint < motion::finger_joint_count; ++joint) {
    const bool left = motion::is_left_finger(joint);
    const auto segment = static_cast<std::size_t>(motion::segment_of(joint));
    std::string finger(fingers[static_cast<std::size_t>(motion::finger_of(joint))]);
    const std::string number = std::to_string(segment + 1);
    if (naming == FingerNaming::vrm) {
      body.push_back((left ? "left" : "right") + finger + std::string(vrm_segments[segment]));
      continue;
    }
    if (finger == "Little") finger = "Pinky";
    if (naming == FingerNaming::mixamo) {
      body.push_back("mixamorig:" + std::string(left ? "LeftHand" : "RightHand") + finger + number);
      continue;
    }
    finger.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(finger.front())));
    body.push_back((left ? "left_" : "right_") + finger + number);
  }
  return body;
}

std::vector<std::string> smpl_names() {
  return {"pelvis",         "spine1",        "spine2",      "neck",       "head",
          "left_collar",    "left_shoulder", "left_elbow",  "left_wrist", "right_collar",
          "right_shoulder", "right_elbow",   "right_wrist", "left_hip",   "left_knee",
          "left_ankle",     "left_foot",     "right_hip",   "right_knee", "right_ankle",
          "right_foot"};
}

std::string two_pixels() {
  return "data:image/png;base64,"
         "iVBORw0KGgoAAAANSUhEUgAAAAIAAAABCAIAAAB7QOjdAAAAD0lEQVR4nGP4z8DA8J8BAAf/"
         "Af8Bf4mnAAAAAElFTkSuQmCC";
}

std::string webp_halves() {
  return "data:image/webp;base64,"
         "UklGRjYAAABXRUJQVlA4TCkAAAAvD8ABACASIOns8X90jyOodiEB0Rx000GNTMAytmsooP8TwPNE/dD/AAA=";
}

}  // namespace mien::test
