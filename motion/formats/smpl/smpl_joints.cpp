#include "motion/formats/smpl/smpl_joints.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "motion/skeleton/body.h"

namespace mien::motion {

namespace {

struct BodyPart {
  std::string_view name;
  int parent;
  int body_joint;  ///< canonical joint at the same place; −1 for spine2
};

constexpr std::array<BodyPart, 22> body_parts = {{
    {"pelvis", -1, Pelvis},
    {"left_hip", 0, LeftHip},
    {"right_hip", 0, RightHip},
    {"spine1", 0, Spine},
    {"left_knee", 1, LeftKnee},
    {"right_knee", 2, RightKnee},
    {"spine2", 3, -1},
    {"left_ankle", 4, LeftAnkle},
    {"right_ankle", 5, RightAnkle},
    {"spine3", 6, Chest},
    {"left_foot", 7, LeftToe},
    {"right_foot", 8, RightToe},
    {"neck", 9, Neck},
    {"left_collar", 9, LeftClavicle},
    {"right_collar", 9, RightClavicle},
    {"head", 12, Head},
    {"left_shoulder", 13, LeftShoulder},
    {"right_shoulder", 14, RightShoulder},
    {"left_elbow", 16, LeftElbow},
    {"right_elbow", 17, RightElbow},
    {"left_wrist", 18, LeftWrist},
    {"right_wrist", 19, RightWrist},
}};
constexpr int spine2 = 6;
constexpr int spine3 = 9;
constexpr int head = 15;
constexpr int left_wrist = 20;
constexpr int right_wrist = 21;

/// A finger of the left hand at rest, palm down: where it begins on the hand, and where each next
/// joint and the tip are from the one before. Metres at a stature of 1.75 m.
struct Finger {
  std::string_view name;
  std::array<Vec3, 4> offsets;
};

const std::array<Finger, 5>& fingers() {
  static const std::array<Finger, 5> all = {{
      {"index", {Vec3{0.082, 0, 0.022}, {0.038, 0, 0}, {0.022, 0, 0}, {0.019, 0, 0}}},
      {"middle", {Vec3{0.083, 0, 0}, {0.042, 0, 0}, {0.025, 0, 0}, {0.020, 0, 0}}},
      {"pinky", {Vec3{0.074, 0, -0.036}, {0.030, 0, 0}, {0.018, 0, 0}, {0.017, 0, 0}}},
      {"ring", {Vec3{0.080, 0, -0.019}, {0.039, 0, 0}, {0.023, 0, 0}, {0.019, 0, 0}}},
      {"thumb",
       {Vec3{0.022, -0.008, 0.026}, {0.032, 0, 0.024}, {0.026, 0, 0.012}, {0.022, 0, 0.006}}},
  }};
  return all;
}

void add_body(Skeleton& skeleton) {
  const Skeleton body = standard_body();
  for (const BodyPart& part : body_parts) {
    Joint joint;
    joint.name = part.name;
    joint.parent = part.parent;
    if (part.body_joint > Pelvis) {
      const Joint& own = body.joints[static_cast<std::size_t>(part.body_joint)];
      joint.offset = own.offset;
      joint.tip = own.tip;
    }
    skeleton.joints.push_back(std::move(joint));
  }
  skeleton.joints[spine2].offset = 0.5 * skeleton.joints[spine3].offset;
  skeleton.joints[spine3].offset -= skeleton.joints[spine2].offset;
}

void add_face(Skeleton& skeleton) {
  skeleton.joints.push_back({"jaw", head, {0, 0.01, 0.02}, std::nullopt});
  skeleton.joints.push_back({"left_eye", head, {0.032, 0.065, 0.08}, std::nullopt});
  skeleton.joints.push_back({"right_eye", head, {-0.032, 0.065, 0.08}, std::nullopt});
}

void add_fingers(Skeleton& skeleton, bool is_left) {
  const auto placed = [&](const Vec3& offset) -> Vec3 {
    return {is_left ? offset.x() : -offset.x(), offset.y(), offset.z()};
  };
  for (const Finger& finger : fingers()) {
    int parent = is_left ? left_wrist : right_wrist;
    for (std::size_t k = 0; k < 3; ++k) {
      Joint joint;
      joint.name = std::string(is_left ? "left_" : "right_") + std::string(finger.name) +
                   std::to_string(k + 1);
      joint.parent = parent;
      joint.offset = placed(finger.offsets[k]);
      if (k == 2) joint.tip = placed(finger.offsets[3]);
      parent = skeleton.size();
      skeleton.joints.push_back(std::move(joint));
    }
  }
}

/// SMPL's hands are single joints at the middle of the hand.
void add_whole_hands(Skeleton& skeleton) {
  for (const int wrist : {left_wrist, right_wrist}) {
    const Vec3 middle = 0.5 * *skeleton.joints[static_cast<std::size_t>(wrist)].tip;
    skeleton.joints.push_back(
        {wrist == left_wrist ? "left_hand" : "right_hand", wrist, middle, middle});
  }
}

}  // namespace

bool is_smpl_joint_count(std::size_t joints) {
  return joints == 22 || joints == 24 || joints == 52 || joints == 55;
}

std::string_view smpl_layout_name(std::size_t joints) {
  return joints == 55 ? "SMPL-X" : joints == 52 ? "SMPL-H" : joints == 24 ? "SMPL" : "SMPL body";
}

Skeleton smpl_skeleton(std::size_t joints) {
  assert(is_smpl_joint_count(joints));
  Skeleton skeleton;
  add_body(skeleton);
  if (joints == 24) add_whole_hands(skeleton);
  if (joints == 55) add_face(skeleton);
  if (joints >= 52) {
    add_fingers(skeleton, true);
    add_fingers(skeleton, false);
  }
  return skeleton;
}

int smpl_joint_of(int body_joint) {
  const auto part = std::find_if(body_parts.begin(), body_parts.end(),
                                 [&](const BodyPart& one) { return one.body_joint == body_joint; });
  return static_cast<int>(part - body_parts.begin());
}

}  // namespace mien::motion
