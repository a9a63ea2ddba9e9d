#include "motion/skeleton/recorded_hands.h"

#include <cassert>

#include "motion/math/rotation.h"
#include "motion/skeleton/hand_tip.h"

namespace mien::motion {

namespace {

/// The joints of `with_fingers`, depth first.
std::vector<int> order_of_handed_body() {
  std::vector<int> order;
  for (int joint = 0; joint < body_joint_count; ++joint) {
    order.push_back(joint);
    if (joint != LeftWrist && joint != RightWrist) continue;
    const int first = body_joint_count + (joint == LeftWrist ? 0 : joints_per_hand);
    for (int k = 0; k < joints_per_hand; ++k) order.push_back(first + k);
  }
  return order;
}

Skeleton reordered(const Skeleton& skeleton, const std::vector<int>& order) {
  std::vector<int> place(order.size());
  for (size_t k = 0; k < order.size(); ++k) place[static_cast<size_t>(order[k])] = int(k);
  Skeleton result;
  for (const int joint : order) {
    result.joints.push_back(skeleton.joints[static_cast<size_t>(joint)]);
    int& parent = result.joints.back().parent;
    if (parent >= 0) parent = place[static_cast<size_t>(parent)];
  }
  return result;
}

Pose reordered(const Pose& pose, const std::vector<int>& order) {
  Pose result = pose;
  for (size_t k = 0; k < order.size(); ++k)
    result.rotations[k] = pose.rotations[static_cast<size_t>(order[k])];
  return result;
}

bool is_finger_name(const std::string& name) {
  for (int joint = 0; joint < finger_joint_count; ++joint)
    if (name == finger_joint_name(joint)) return true;
  return false;
}

}  // namespace

bool has_fingers(const Clip& clip) {
  return !clip.poses.empty() && !clip.poses.front().fingers.empty();
}

void add_hands(Recording& recording) {
  const std::vector<int> order = order_of_handed_body();
  recording.skeleton = reordered(with_fingers(recording.skeleton), order);
  for (Pose& pose : recording.poses) {
    assert(pose.fingers.size() == finger_joint_count);
    pose = reordered(with_fingers(pose), order);
  }
}

Skeleton without_fingers(const Skeleton& skeleton) {
  Skeleton result;
  std::vector<int> place;
  for (const Joint& joint : skeleton.joints) {
    const int parent = joint.parent < 0 ? -1 : place[static_cast<size_t>(joint.parent)];
    if (is_finger_name(joint.name) || (joint.parent >= 0 && parent < 0)) {
      place.push_back(-1);
      continue;
    }
    place.push_back(result.size());
    result.joints.push_back(joint);
    result.joints.back().parent = parent;
  }
  return result;
}

std::array<Vec3, 2 * fingers_per_hand> fingertips(const Skeleton& body, const Pose& pose) {
  assert(pose.fingers.size() == finger_joint_count);
  const double length = hand_length(body);
  std::array<Vec3, 2 * fingers_per_hand> tips;
  for (size_t tip = 0; tip < tips.size(); ++tip) {
    const bool left = tip < fingers_per_hand;
    const auto finger = Finger(tip % fingers_per_hand);
    Vec3 place = Vec3::Zero();
    Quat turn = Quat::Identity();
    for (int segment = 0; segment < joints_per_finger; ++segment) {
      const int joint = finger_joint(left, finger, segment);
      place += turn * finger_offset(joint, length);
      turn = turn * pose.fingers[static_cast<size_t>(joint)];
    }
    tips[tip] = place + turn * fingertip_offset(left, finger, length);
  }
  return tips;
}

bool are_straight_and_still(const std::vector<Pose>& poses) {
  constexpr double least_turn = 1e-6;
  constexpr double bent = 10.0 * radians_per_degree;
  for (int joint = 0; joint < finger_joint_count; ++joint) {
    const auto j = static_cast<size_t>(joint);
    const Quat& first = poses.front().fingers[j];
    if (finger_of(joint) != Finger::thumb && angle_between(Quat::Identity(), first) > bent)
      return false;
    for (const Pose& pose : poses)
      if (angle_between(first, pose.fingers[j]) > least_turn) return false;
  }
  return true;
}

}  // namespace mien::motion
