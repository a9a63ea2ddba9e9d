#include "motion/skeleton/body.h"

#include <algorithm>
#include <cassert>

namespace mien::motion {

namespace {

struct JointNames {
  std::string_view english;
  std::string_view japanese;
};

constexpr std::array<JointNames, body_joint_count> joint_names = {{
    {"Pelvis", "骨盤"},
    {"Spine", "腰椎"},
    {"Chest", "胸"},
    {"Neck", "首"},
    {"Head", "頭"},
    {"LeftClavicle", "左鎖骨"},
    {"LeftShoulder", "左肩"},
    {"LeftElbow", "左肘"},
    {"LeftWrist", "左手首"},
    {"RightClavicle", "右鎖骨"},
    {"RightShoulder", "右肩"},
    {"RightElbow", "右肘"},
    {"RightWrist", "右手首"},
    {"LeftHip", "左股関節"},
    {"LeftKnee", "左膝"},
    {"LeftAnkle", "左足首"},
    {"LeftToe", "左つま先"},
    {"RightHip", "右股関節"},
    {"RightKnee", "右膝"},
    {"RightAnkle", "右足首"},
    {"RightToe", "右つま先"},
}};

constexpr int left_to_right_arm = RightClavicle - LeftClavicle;
constexpr int left_to_right_leg = RightHip - LeftHip;

size_t index(BodyJoint joint) { return static_cast<size_t>(joint); }

}  // namespace

std::string_view name_of(BodyJoint joint) { return joint_names[index(joint)].english; }

std::string_view japanese_name_of(BodyJoint joint) { return joint_names[index(joint)].japanese; }

bool is_left(BodyJoint joint) {
  return (joint >= LeftClavicle && joint <= LeftWrist) || (joint >= LeftHip && joint <= LeftToe);
}

bool is_right(BodyJoint joint) {
  return (joint >= RightClavicle && joint <= RightWrist) ||
         (joint >= RightHip && joint <= RightToe);
}

BodyJoint mirrored(BodyJoint joint) {
  if (joint >= LeftHip && joint <= LeftToe) return BodyJoint(joint + left_to_right_leg);
  if (joint >= RightHip) return BodyJoint(joint - left_to_right_leg);
  if (is_left(joint)) return BodyJoint(joint + left_to_right_arm);
  if (is_right(joint)) return BodyJoint(joint - left_to_right_arm);
  return joint;
}

Vec3 rest_direction(BodyJoint joint) {
  if (joint <= Head) return Vec3::UnitY();
  if (joint <= LeftWrist) return Vec3::UnitX();
  if (joint <= RightWrist) return -Vec3::UnitX();
  if (joint == LeftToe || joint == RightToe || joint == LeftAnkle || joint == RightAnkle) {
    return Vec3::UnitZ();
  }
  return -Vec3::UnitY();
}

Skeleton standard_body(double height_m) {
  // Metres at a stature of 1.75 m: limb segments after de Leva 1996 (thigh 0.425, shank 0.436,
  // upper arm 0.283, forearm 0.270 at 1.741 m), breadths and trunk divisions rounded from the same
  // source. The ankle stands 0.08 m above the sole.
  struct Part {
    BodyJoint joint;
    Vec3 offset;
  };
  const std::array<Part, body_joint_count> left_and_middle = {{
      {Pelvis, {0, 0, 0}},
      {Spine, {0, 0.11, 0}},
      {Chest, {0, 0.17, 0}},
      {Neck, {0, 0.24, 0}},
      {Head, {0, 0.10, 0}},
      {LeftClavicle, {0.02, 0.18, 0}},
      {LeftShoulder, {0.165, 0, 0}},
      {LeftElbow, {0.285, 0, 0}},
      {LeftWrist, {0.265, 0, 0}},
      {RightClavicle, {-0.02, 0.18, 0}},
      {RightShoulder, {-0.165, 0, 0}},
      {RightElbow, {-0.285, 0, 0}},
      {RightWrist, {-0.265, 0, 0}},
      {LeftHip, {0.09, -0.03, 0}},
      {LeftKnee, {0, -0.43, 0}},
      {LeftAnkle, {0, -0.42, 0}},
      {LeftToe, {0, -0.06, 0.13}},
      {RightHip, {-0.09, -0.03, 0}},
      {RightKnee, {0, -0.43, 0}},
      {RightAnkle, {0, -0.42, 0}},
      {RightToe, {0, -0.06, 0.13}},
  }};
  const double scale = height_m / 1.75;
  Skeleton body;
  body.joints.resize(body_joint_count);
  for (const auto& [joint, offset] : left_and_middle) {
    body.joints[index(joint)] = {std::string(name_of(joint)), body_parents[index(joint)],
                                 offset * scale, std::nullopt};
  }
  body.joints[Head].tip = Vec3(0, 0.17, 0) * scale;
  body.joints[LeftWrist].tip = Vec3(0.17, 0, 0) * scale;
  body.joints[RightWrist].tip = Vec3(-0.17, 0, 0) * scale;
  body.joints[LeftToe].tip = Vec3(0, 0, 0.06) * scale;
  body.joints[RightToe].tip = Vec3(0, 0, 0.06) * scale;
  return body;
}

Skeleton standard_female_body(double height_m) {
  Skeleton body = standard_body(height_m);
  for (const BodyJoint shoulder : {LeftShoulder, RightShoulder}) {
    body.joints[index(shoulder)].offset.x() *= 0.9;
  }
  for (const BodyJoint hip : {LeftHip, RightHip}) body.joints[index(hip)].offset.x() *= 1.06;
  return body;
}

bool is_body(const Skeleton& skeleton) {
  if (skeleton.size() != body_joint_count) return false;
  for (int j = 0; j < body_joint_count; ++j) {
    const Joint& joint = skeleton.joints[static_cast<size_t>(j)];
    if (joint.name != name_of(BodyJoint(j))) return false;
    if (joint.parent != body_parents[static_cast<size_t>(j)]) return false;
  }
  return true;
}

double leg_length(const Skeleton& body) {
  assert(is_body(body));
  const auto length = [&](BodyJoint joint) { return body.joints[index(joint)].offset.norm(); };
  return 0.5 * (length(LeftKnee) + length(LeftAnkle) + length(RightKnee) + length(RightAnkle));
}

double standing_height(const Skeleton& body) {
  assert(is_body(body));
  std::array<double, body_joint_count> heights{};
  for (size_t j = 1; j < body_joint_count; ++j) {
    heights[j] = heights[static_cast<size_t>(body_parents[j])] + body.joints[j].offset.y();
  }
  double lowest = 0.0;
  double highest = 0.0;
  for (size_t j = 0; j < body_joint_count; ++j) {
    const double tip = heights[j] + (body.joints[j].tip ? body.joints[j].tip->y() : 0.0);
    lowest = std::min({lowest, heights[j], tip});
    highest = std::max({highest, heights[j], tip});
  }
  return highest - lowest;
}

double relative_stature(const Skeleton& body) {
  return standing_height(body) / 1.73;  // 1.75 m less the 0.02 m below the toe joint
}

}  // namespace mien::motion
