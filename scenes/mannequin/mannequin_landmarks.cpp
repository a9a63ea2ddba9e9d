#include "scenes/mannequin/mannequin_landmarks.h"

#include <algorithm>

#include "motion/math/rotation.h"

namespace mien::scenes {

namespace {

using motion::BodyJoint;
using motion::Vec3;

constexpr double most_sunk = 0.03;  // metres at 1.75 m: of the head below the rig's end of it
constexpr double most_lift = 20.0 * motion::radians_per_degree;
constexpr double least_stretch = 0.4;  // so that there is a trunk even where hips touch shoulders

// Dimensions of the standard body, metres at 1.75 m.
constexpr double crown = 0.17;                 // above the joint of the head
constexpr double shoulders_below_head = 0.16;  // that joint

Vec3 middle_of(const motion::JointTransforms& pose, BodyJoint left, BodyJoint right) {
  return 0.5 * (pose.positions[left] + pose.positions[right]);
}

double half_between(const motion::JointTransforms& pose, BodyJoint left, BodyJoint right) {
  return 0.5 * (pose.positions[left] - pose.positions[right]).norm();
}

}  // namespace

double Trunk::stretch() const {
  return std::max((shoulders - hips).y() / scale / shoulder_level, least_stretch);
}

double Trunk::breadth() const { return std::clamp(half_shoulders / 0.185, 0.75, 1.35); }

double Trunk::waist() const { return 0.5 * (breadth() + (half_hips + 0.068) / 0.158); }

Vec3 Trunk::at(const Vec3& place) const {
  const Vec3 axis = hips + (shoulders - hips) * (place.y() / shoulder_level);
  return axis + scale * Vec3(place.x(), 0.0, place.z());
}

Trunk trunk_of(const motion::Skeleton& body, const motion::JointTransforms& pose) {
  const double scale = motion::relative_stature(body);
  return {middle_of(pose, motion::LeftHip, motion::RightHip),
          middle_of(pose, motion::LeftShoulder, motion::RightShoulder), scale,
          half_between(pose, motion::LeftHip, motion::RightHip) / scale,
          half_between(pose, motion::LeftShoulder, motion::RightShoulder) / scale};
}

HeadShape head_shape(const motion::Skeleton& body) {
  const double scale = motion::relative_stature(body);
  const Vec3 tip = body.joints[motion::Head].tip.value_or(Vec3(0.0, crown * scale, 0.0)) / scale;
  const double fitting = std::clamp(tip.y() / crown, 1.0, 1.12);
  // Where it is too short it ends inside the skull. A head sunk as far would leave no neck, so the
  // figure becomes taller than its bones, and its head larger with it.
  const double raise = std::max(tip.y() - fitting * crown, -most_sunk);
  const double taller = fitting * crown + raise - tip.y();
  return {fitting * (1.0 + taller / 1.75), scale * Vec3(0.0, raise, 0.0)};
}

double collar_lift(const motion::Skeleton& body) {
  const double scale = motion::relative_stature(body);
  const auto offset = [&](BodyJoint joint) { return body.joints[joint].offset; };
  const double skull =
      (offset(motion::Neck) + offset(motion::Head)).y() + std::max(head_shape(body).raise.y(), 0.0);
  const Vec3 collar = offset(motion::LeftShoulder);
  const double shoulder = offset(motion::LeftClavicle).y() + collar.y();
  const double missing = skull - shoulder - shoulders_below_head * scale;
  const double length = collar.norm();
  // Short collar bones lie where they are and turn little.
  const double share = std::clamp((length / scale - 0.08) / 0.07, 0.0, 1.0);
  return share * std::clamp(missing / std::max(length, 1e-6), -most_lift, most_lift);
}

}  // namespace mien::scenes
