#include "motion/rig/hand_mapping.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "motion/math/rotation.h"

namespace mien::motion {

namespace {

constexpr double unit_hand = 1.0;  // only directions count

BodyJoint wrist_of(bool left) { return left ? LeftWrist : RightWrist; }

/// One hand of a rig in a reference pose.
struct ReferenceHand {
  const Skeleton& rig;
  const JointTransforms& pose;
  const FingerJoints& fingers;
  bool left;
  int wrist;

  int joint(Finger finger, int segment) const {
    return fingers.joints[static_cast<size_t>(finger_joint(left, finger, segment))];
  }
  const Vec3& place(int rig_joint) const { return pose.positions[static_cast<size_t>(rig_joint)]; }
  const Quat& turn(int rig_joint) const { return pose.rotations[static_cast<size_t>(rig_joint)]; }

  /// Where a finger's bone leads from its joint; empty if the rig does not tell.
  std::optional<Vec3> bone(Finger finger, int segment) const {
    const int from = joint(finger, segment);
    if (from < 0) return std::nullopt;
    int to = segment + 1 < joints_per_finger ? joint(finger, segment + 1) : -1;
    const size_t number = static_cast<size_t>(finger) + (left ? 0 : fingers_per_hand);
    if (to < 0) to = fingers.ends[number];
    const std::optional<Vec3>& tip = rig.joints[static_cast<size_t>(from)].tip;
    Vec3 along = Vec3::Zero();
    if (to >= 0)
      along = place(to) - place(from);
    else if (tip)
      along = turn(from) * *tip;
    const double length = along.norm();
    if (!(length > 1e-9)) return std::nullopt;
    return Vec3(along / length);
  }
};

Vec3 canonical_bone(bool left, Finger finger, int segment) {
  if (segment + 1 == joints_per_finger) return fingertip_offset(left, finger, unit_hand);
  return finger_offset(finger_joint(left, finger, segment + 1), unit_hand);
}

/// The knuckles of the fingers but the thumb: the middle of them from the wrist, and the line from
/// the last to the first, towards the thumb.
struct Knuckles {
  Vec3 along = Vec3::Zero();
  Vec3 across = Vec3::Zero();
};

/// Those of the rig and, of the same fingers, those of the canonical hand.
std::array<Knuckles, 2> knuckles_of(const ReferenceHand& hand) {
  std::array<Knuckles, 2> both;
  std::array<Vec3, 2> first = {Vec3::Zero(), Vec3::Zero()};
  double count = 0.0;
  for (int f = static_cast<int>(Finger::index); f < fingers_per_hand; ++f) {
    const int joint = hand.joint(Finger(f), 0);
    if (joint < 0) continue;
    const std::array<Vec3, 2> places = {
        Vec3(hand.place(joint) - hand.place(hand.wrist)),
        finger_offset(finger_joint(hand.left, Finger(f), 0), unit_hand)};
    for (size_t k = 0; k < 2; ++k) {
      if (count == 0.0) first[k] = places[k];
      both[k].along += places[k];
      both[k].across = first[k] - places[k];
    }
    count += 1.0;
  }
  return both;
}

/// The canonical hand in the space of the reference pose; empty if the knuckles do not tell.
std::optional<Quat> palm_rotation(const ReferenceHand& hand) {
  const auto [rig, canonical] = knuckles_of(hand);
  const double area = rig.along.cross(rig.across).norm();
  if (!(area > 0.02 * rig.along.squaredNorm())) return std::nullopt;
  return (frame_from(rig.along, rig.across) *
          frame_from(canonical.along, canonical.across).conjugate())
      .normalized();
}

/// How straight the fingers are: the sum of the cosines between the bones.
double straightness(const ReferenceHand& hand) {
  const Vec3 along = knuckles_of(hand)[0].along.normalized();
  double sum = 0.0;
  for (int f = 0; f < fingers_per_hand; ++f) {
    Vec3 before = along;
    for (int segment = 0; segment < joints_per_finger; ++segment) {
      const std::optional<Vec3> bone = hand.bone(Finger(f), segment);
      if (!bone) continue;
      sum += bone->dot(before);
      before = *bone;
    }
  }
  return sum;
}

/// Lays the canonical bones of a finger on those of the rig, from the palm outwards.
void lay_finger(const ReferenceHand& hand, Finger finger, const Quat& palm, HandMapping& hands) {
  Quat laid = palm;
  for (int segment = 0; segment < joints_per_finger; ++segment) {
    const int rig_joint = hand.joint(finger, segment);
    if (rig_joint < 0) continue;
    if (const std::optional<Vec3> bone = hand.bone(finger, segment)) {
      const Vec3 straight = laid * canonical_bone(hand.left, finger, segment);
      laid = (turn_between(straight, *bone) * laid).normalized();
    }
    hands.calibration[static_cast<size_t>(finger_joint(hand.left, finger, segment))] =
        (hand.turn(rig_joint).conjugate() * laid).normalized();
  }
}

void calibrate_hand(const ReferenceHand& hand, HandMapping& hands) {
  const std::optional<Quat> palm = palm_rotation(hand);
  if (!palm) return;
  const size_t side = hand.left ? 0 : 1;
  hands.is_hand[side] = true;
  hands.palm[side] = (hand.turn(hand.wrist).conjugate() * *palm).normalized();
  for (int f = 0; f < fingers_per_hand; ++f) {
    lay_finger(hand, Finger(f), *palm, hands);
    for (int segment = 0; segment < joints_per_finger; ++segment) {
      const auto joint = static_cast<size_t>(finger_joint(hand.left, Finger(f), segment));
      hands.joints[joint] = hand.fingers.joints[joint];
    }
  }
}

/// The frame in which the fingers of a hand are straightest.
const JointTransforms& straightest_frame(std::span<const RigMotion> motions,
                                         const FingerJoints& fingers, bool left, int wrist) {
  const JointTransforms* best = nullptr;
  double most = 0.0;
  for (const RigMotion& motion : motions) {
    for (const JointTransforms& frame : motion.frames) {
      const double value = straightness({motion.rig, frame, fingers, left, wrist});
      if (best != nullptr && !(value > most)) continue;
      best = &frame;
      most = value;
    }
  }
  return *best;
}

int side_begin(bool left) { return left ? 0 : joints_per_hand; }

std::string hand_in_words(bool left) { return left ? "left" : "right"; }

}  // namespace

HandMapping no_hands() {
  HandMapping hands;
  hands.joints.fill(-1);
  hands.calibration.fill(Quat::Identity());
  hands.palm.fill(Quat::Identity());
  return hands;
}

HandMapping hand_mapping(std::span<const RigMotion> motions, bool zero_pose_is_figure,
                         bool is_own) {
  HandMapping hands = no_hands();
  const RigMotion& first = motions.front();
  const auto wrist = [&](bool left) { return first.joints[wrist_of(left)].rotation(); };
  const FingerJoints fingers = finger_joints(first.rig, wrist(true), wrist(false));
  for (const bool left : {true, false}) {
    const size_t side = left ? 0 : 1;
    if (!fingers.is_hand[side]) continue;
    const JointTransforms reference = zero_pose_is_figure
                                          ? zero_pose(first.rig)
                                          : straightest_frame(motions, fingers, left, wrist(left));
    calibrate_hand({first.rig, reference, fingers, left, wrist(left)}, hands);
    if (is_own) hands.palm[side] = Quat::Identity();
  }
  if (is_own) hands.calibration.fill(Quat::Identity());
  return hands;
}

std::vector<Quat> finger_rotations(const RigMotion& motion, const JointTransforms& frame,
                                   const HandMapping& hands) {
  std::vector<Quat> fingers = relaxed_fingers();
  for (const bool left : {true, false}) {
    if (!hands.has(left)) continue;
    const Quat palm = motion.rotation(frame, wrist_of(left)) * hands.palm[left ? 0 : 1];
    Quat above = palm;
    for (int joint = side_begin(left); joint < side_begin(left) + joints_per_hand; ++joint) {
      const auto at = static_cast<size_t>(joint);
      if (segment_of(joint) == 0) above = palm;
      const int rig_joint = hands.joints[at];
      const Quat global =
          rig_joint < 0 ? above
                        : frame.rotations[static_cast<size_t>(rig_joint)] * hands.calibration[at];
      fingers[at] = (above.conjugate() * global).normalized();
      above = global;
    }
  }
  return fingers;
}

bool are_fingers_unrecorded(const Recording& recording, const HandMapping& hands) {
  constexpr double least_turn = 1e-6;
  for (const Pose& pose : recording.poses) {
    for (const int joint : hands.joints) {
      if (joint < 0) continue;
      const Quat& rotation = pose.rotations[static_cast<size_t>(joint)];
      if (angle_between(Quat::Identity(), rotation) > least_turn) return false;
    }
  }
  return true;
}

std::vector<std::string> missing_finger_joints(const HandMapping& hands) {
  std::vector<std::string> missing;
  for (int joint = 0; joint < finger_joint_count; ++joint) {
    if (hands.has(is_left_finger(joint)) && hands.joints[static_cast<size_t>(joint)] < 0)
      missing.push_back(finger_joint_name(joint));
  }
  return missing;
}

std::vector<std::string> hand_warnings(const HandMapping& hands) {
  std::vector<std::string> warnings;
  if (!hands.any()) return warnings;
  for (const bool left : {true, false}) {
    if (hands.has(left)) continue;
    warnings.push_back("The rig has no fingers of the " + hand_in_words(left) +
                       " hand; they are shown at ease.");
  }
  std::string list;
  for (const std::string& name : missing_finger_joints(hands))
    list += (list.empty() ? "" : ", ") + name;
  if (!list.empty())
    warnings.push_back("The rig has no joint for " + list + "; the finger is straight there.");
  return warnings;
}

}  // namespace mien::motion
