#pragma once

#include <array>
#include <vector>

#include "motion/skeleton/body.h"
#include "motion/skeleton/hand.h"
#include "motion/skeleton/pose.h"
#include "scenes/mannequin/sdf_primitive.h"

namespace mien::scenes {

/// Length of a body's hands relative to one of 0.189 m (hand_tip.h).
double hand_scale(const motion::Skeleton& body);

/// Rotations of the finger joints in the bind pose of a mannequin: straight fingers, spread so far
/// that the surfaces of neighbours are apart.
std::vector<motion::Quat> modelling_fingers();

/// Whether joint transforms of a mannequin include those of fingers (motion::with_fingers).
bool includes_fingers(const motion::JointTransforms& pose);

/// Index in motion::with_fingers of a joint of the hands.
constexpr int with_body(int finger_joint) { return motion::body_joint_count + finger_joint; }

/// The joint of the body that a joint of motion::with_fingers belongs to: itself, or the wrist.
motion::BodyJoint body_joint_at(int joint);

/// The palm and five fingers of a hand in the bind pose, which includes fingers. Fingers end at
/// their tips. `thickness` is relative to a hand of 0.189 m.
std::vector<SdfPrimitive> hand_flesh(const motion::JointTransforms& pose,
                                     const std::vector<motion::Vec3>& fingertips, bool left,
                                     double thickness);

/// The shares of the joints of a hand in a point of its surface, in the bind pose; what is missing
/// to 1 is the wrist's. Each finger moves its own surface, the thumb also the ball of the thumb;
/// between two fingers the shares pass from one to the other. `scale` as for `hand_flesh`.
std::array<double, motion::joints_per_hand> finger_shares(
    const motion::JointTransforms& pose, const std::vector<motion::Vec3>& fingertips, bool left,
    double scale, const motion::Vec3& point);

/// The tips of all fingers, world space, the left hand's first.
std::vector<motion::Vec3> fingertips_of(const motion::Skeleton& body,
                                        const motion::JointTransforms& pose);

}  // namespace mien::scenes
