#include "motion/skeleton/hand.h"

#include <array>
#include <numbers>
#include <string_view>

#include "motion/skeleton/body.h"
#include "motion/skeleton/hand_tip.h"

namespace mien::motion {

namespace {

/// A finger of the left hand at rest, palm down: where it begins on the hand, and where each next
/// joint and the tip are from the one before. Metres on a hand of `table_length`.
using FingerOffsets = std::array<Vec3, joints_per_finger + 1>;

constexpr double table_length = 0.170;

const std::array<FingerOffsets, fingers_per_hand>& offsets_of_fingers() {
  static const std::array<FingerOffsets, fingers_per_hand> all = {{
      {Vec3{0.022, -0.008, 0.026}, {0.032, 0, 0.024}, {0.026, 0, 0.012}, {0.022, 0, 0.006}},
      {Vec3{0.082, 0, 0.022}, {0.038, 0, 0}, {0.022, 0, 0}, {0.019, 0, 0}},
      {Vec3{0.083, 0, 0}, {0.042, 0, 0}, {0.025, 0, 0}, {0.020, 0, 0}},
      {Vec3{0.080, 0, -0.019}, {0.039, 0, 0}, {0.023, 0, 0}, {0.019, 0, 0}},
      {Vec3{0.074, 0, -0.036}, {0.030, 0, 0}, {0.018, 0, 0}, {0.017, 0, 0}},
  }};
  return all;
}

Vec3 on_hand(bool left, const Vec3& of_left, double hand_length) {
  const Vec3 scaled = (hand_length / table_length) * of_left;
  return {left ? scaled.x() : -scaled.x(), scaled.y(), scaled.z()};
}

Vec3 table_offset(Finger finger, int at) {
  return offsets_of_fingers()[static_cast<std::size_t>(finger)][static_cast<std::size_t>(at)];
}

/// Degrees of flexion of each joint of a hand at ease.
constexpr std::array<std::array<double, joints_per_finger>, fingers_per_hand> relaxed_degrees = {{
    {8, 12, 18},
    {18, 28, 14},
    {24, 32, 16},
    {28, 34, 18},
    {32, 34, 18},
}};

}  // namespace

std::string finger_joint_name(int joint) {
  constexpr std::array<std::string_view, fingers_per_hand> names = {"Thumb", "Index", "Middle",
                                                                    "Ring", "Little"};
  return std::string(is_left_finger(joint) ? "Left" : "Right") +
         std::string(names[static_cast<std::size_t>(finger_of(joint))]) +
         std::to_string(segment_of(joint) + 1);
}

Vec3 finger_offset(int joint, double hand_length) {
  return on_hand(is_left_finger(joint), table_offset(finger_of(joint), segment_of(joint)),
                 hand_length);
}

Vec3 fingertip_offset(bool left, Finger finger, double hand_length) {
  return on_hand(left, table_offset(finger, joints_per_finger), hand_length);
}

Vec3 flexion_axis(int joint) {
  const bool left = is_left_finger(joint);
  const Vec3 along = on_hand(left, table_offset(finger_of(joint), segment_of(joint) + 1), 1.0);
  const Vec3 inward =
      finger_of(joint) == Finger::thumb ? Vec3(-Vec3::UnitY() - Vec3::UnitZ()) : -Vec3::UnitY();
  return along.cross(inward).normalized();
}

const std::vector<Quat>& relaxed_fingers() {
  static const std::vector<Quat> fingers = [] {
    std::vector<Quat> all(finger_joint_count);
    for (int joint = 0; joint < finger_joint_count; ++joint) {
      const double degrees = relaxed_degrees[static_cast<std::size_t>(finger_of(joint))]
                                            [static_cast<std::size_t>(segment_of(joint))];
      all[static_cast<std::size_t>(joint)] =
          Quat(Eigen::AngleAxisd(degrees * std::numbers::pi / 180.0, flexion_axis(joint)));
    }
    return all;
  }();
  return fingers;
}

Skeleton with_fingers(const Skeleton& body) {
  Skeleton handed = body;
  const double length = hand_length(body);
  for (int joint = 0; joint < finger_joint_count; ++joint) {
    const bool left = is_left_finger(joint);
    const bool first = segment_of(joint) == 0;
    Joint finger{.name = finger_joint_name(joint),
                 .parent = first ? (left ? LeftWrist : RightWrist) : handed.size() - 1,
                 .offset = finger_offset(joint, length),
                 .tip = {}};
    if (segment_of(joint) == joints_per_finger - 1) {
      finger.tip = fingertip_offset(left, finger_of(joint), length);
    }
    handed.joints.push_back(std::move(finger));
  }
  return handed;
}

Pose with_fingers(const Pose& pose) {
  Pose handed = pose;
  const std::vector<Quat>& fingers = pose.fingers.empty() ? relaxed_fingers() : pose.fingers;
  handed.rotations.insert(handed.rotations.end(), fingers.begin(), fingers.end());
  handed.fingers.clear();
  return handed;
}

}  // namespace mien::motion
