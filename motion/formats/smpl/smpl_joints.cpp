#include "motion/formats/smpl/smpl_joints.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

#include "motion/skeleton/body.h"
#include "motion/skeleton/hand.h"

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

/// The fingers in the order of these layouts.
constexpr std::array<std::pair<std::string_view, Finger>, fingers_per_hand> fingers = {{
    {"index", Finger::index},
    {"middle", Finger::middle},
    {"pinky", Finger::little},
    {"ring", Finger::ring},
    {"thumb", Finger::thumb},
}};

/// Metres; shorter than hand_length, so that the hands are those of earlier versions.
constexpr double smpl_hand_length = 0.170;

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
  for (const auto& [name, finger] : fingers) {
    int parent = is_left ? left_wrist : right_wrist;
    for (int k = 0; k < joints_per_finger; ++k) {
      Joint joint;
      joint.name =
          std::string(is_left ? "left_" : "right_") + std::string(name) + std::to_string(k + 1);
      joint.parent = parent;
      joint.offset = finger_offset(finger_joint(is_left, finger, k), smpl_hand_length);
      if (k == joints_per_finger - 1) {
        joint.tip = fingertip_offset(is_left, finger, smpl_hand_length);
      }
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

int smplh_joint_of_finger(int finger_joint) {
  const auto place = std::find_if(fingers.begin(), fingers.end(), [&](const auto& each) {
    return each.second == finger_of(finger_joint);
  });
  const auto first =
      static_cast<int>(body_parts.size()) + (is_left_finger(finger_joint) ? 0 : joints_per_hand);
  return first + static_cast<int>(place - fingers.begin()) * joints_per_finger +
         segment_of(finger_joint);
}

int smpl_joint_of(int body_joint) {
  const auto part = std::find_if(body_parts.begin(), body_parts.end(),
                                 [&](const BodyPart& one) { return one.body_joint == body_joint; });
  return static_cast<int>(part - body_parts.begin());
}

}  // namespace mien::motion
