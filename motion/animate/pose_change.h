#pragma once

#include <array>

#include "motion/skeleton/pose.h"

namespace mien::motion {

/// A change of one pose of the canonical body by the parts that an animator places. Lengths in
/// metres, rotation vectors in radians, both along the axes of the room. Pairs: left, right.
struct PoseChange {
  Vec3 pelvis = Vec3::Zero();  ///< moves the trunk; the feet stay
  Vec3 trunk = Vec3::Zero();   ///< rotation of the chest, half of it in the spine
  Vec3 gaze = Vec3::Zero();    ///< rotation of the head, half of it in the neck
  /// Rotation of the arms about their shoulders, and then the logarithm of the factor by which the
  /// distance from shoulder to hand changes.
  std::array<Vec3, 2> swings = {Vec3::Zero(), Vec3::Zero()};
  std::array<double, 2> stretches = {0.0, 0.0};
  std::array<Vec3, 2> hands = {Vec3::Zero(), Vec3::Zero()};  ///< added to where that takes them
  std::array<Vec3, 2> feet = {Vec3::Zero(), Vec3::Zero()};
  std::array<Vec3, 2> hand_turns = {Vec3::Zero(), Vec3::Zero()};
  std::array<Vec3, 2> foot_turns = {Vec3::Zero(), Vec3::Zero()};
};

/// The changed pose. Hands and feet reach their places (body_end.h) by two-bone inverse kinematics
/// (two_bone_ik.h), as far as their limbs reach; hands keep their angle to the forearm, feet their
/// direction in the room, unless they are turned. Bones keep their lengths. Joints on which nothing
/// acts are not touched.
Pose changed(const Skeleton& body, const Pose& pose, const PoseChange& change);

/// How an arm gets its hand to a place: a rotation about the shoulder, and the logarithm of the
/// factor of the distance from shoulder to hand (PoseChange::swings, stretches). Arms that swing by
/// more than 100° pass in front of the body.
struct ArmSwing {
  Vec3 swing = Vec3::Zero();
  double stretch = 0.0;
};

ArmSwing swing_to(const Skeleton& body, const JointTransforms& world, bool left, const Vec3& place);

/// The rotation of the chest with which the arm comes near enough to a place for its hand, as a
/// rotation vector along the axes of the room: zero as long as the arm is bent (its ends are nearer
/// than 0.9 of its length), and smooth from there on. An arm that is straighter in the motion may
/// stay so: `usual` is its extension there (usual_reach).
Vec3 lean_towards(const Skeleton& body, const JointTransforms& world, bool left, const Vec3& place,
                  double usual);
/// The distance from shoulder to hand, metres.
double usual_reach(const Skeleton& body, const JointTransforms& world, bool left);

/// A lean that the trunk can do: smoothly limited to 60°.
Vec3 bounded_lean(const Vec3& lean);

/// The shift of the pelvis with which the leg comes near enough to a place for its foot, metres:
/// zero up to 0.98 of the length of the leg, or up to `usual`, its extension in the motion; at most
/// 0.3 m.
Vec3 shift_towards(const Skeleton& body, const JointTransforms& world, bool left, const Vec3& place,
                   double usual);
/// The distance from hip to ankle, metres.
double usual_extension(const JointTransforms& world, bool left);

}  // namespace mien::motion
