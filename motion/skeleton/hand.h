#pragma once

#include <string>
#include <vector>

#include "motion/skeleton/pose.h"
#include "motion/skeleton/skeleton.h"

namespace mien::motion {

/// The hands that a motion may have beside the canonical body (body.h): three joints for each of
/// five fingers, from the knuckle (for the thumb, from the base of its metacarpal) outwards.
///
/// At rest the hand is flat and the palm down, as on the body in its T-pose: fingers along ±X, the
/// thumb pointing forward and outward in the plane of the palm. As for the body's joints, every
/// joint's frame is then parallel to the world's. Joints 0–14 are those of the left hand, 15–29
/// those of the right, each in the order of Finger.
enum class Finger { thumb, index, middle, ring, little };

inline constexpr int fingers_per_hand = 5;
inline constexpr int joints_per_finger = 3;
inline constexpr int joints_per_hand = fingers_per_hand * joints_per_finger;
inline constexpr int finger_joint_count = 2 * joints_per_hand;

/// The joint `segment` (0: nearest to the wrist … 2) of a finger.
constexpr int finger_joint(bool left, Finger finger, int segment) {
  return (left ? 0 : joints_per_hand) + static_cast<int>(finger) * joints_per_finger + segment;
}

constexpr bool is_left_finger(int joint) { return joint < joints_per_hand; }
constexpr Finger finger_of(int joint) {
  return Finger(joint % joints_per_hand / joints_per_finger);
}
constexpr int segment_of(int joint) { return joint % joints_per_finger; }

/// The same joint of the other hand.
constexpr int mirrored_finger(int joint) { return (joint + joints_per_hand) % finger_joint_count; }

/// Names as they appear in files and tables: "LeftThumb1" … "RightLittle3".
std::string finger_joint_name(int joint);

/// Position of a joint in the frame of the one before it (of the wrist for a finger's first), on a
/// hand of `hand_length` metres (hand_tip.h) of average proportions.
Vec3 finger_offset(int joint, double hand_length);

/// The tip of a finger in the frame of its last joint.
Vec3 fingertip_offset(bool left, Finger finger, double hand_length);

/// Unit axis, in the joint's frame, about which positive angles bend the finger towards the palm
/// (the thumb: across it).
Vec3 flexion_axis(int joint);

/// A hand at ease: each finger a little bent, the little finger most. The angles are our own
/// choice; motions without fingers are shown with them where hands are drawn.
const std::vector<Quat>& relaxed_fingers();

/// The canonical body with its hands' joints, which follow those of the body in their order; a
/// finger's last joint has its tip.
Skeleton with_fingers(const Skeleton& body);

/// A pose of that skeleton: `pose` with its fingers, or with relaxed ones if it has none.
Pose with_fingers(const Pose& pose);

}  // namespace mien::motion
