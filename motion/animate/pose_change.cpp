#include "motion/animate/pose_change.h"

#include <algorithm>
#include <cmath>

#include "motion/animate/body_end.h"
#include "motion/animate/smooth_limit.h"
#include "motion/math/rotation.h"
#include "motion/skeleton/body.h"
#include "motion/skeleton/two_bone_ik.h"

namespace mien::motion {

namespace {

constexpr double bent_arm = 0.9;          // of the arm's length, from where the trunk helps
constexpr double more_extension = 0.06;   // of the arm's length, until which it does the rest
constexpr double most_extension = 0.998;  // of the arm's length
constexpr double most_lean = 60.0 * radians_per_degree;
constexpr double little_lean = 0.3 * radians_per_degree;
constexpr double wide_swing = 100.0 * radians_per_degree;
constexpr double more_swing = 60.0 * radians_per_degree;
constexpr double moved_metres = 0.01;  // from where on a limb bends to its proper side
constexpr double straight_leg = 0.98;
constexpr double most_shift = 0.3;  // metres

struct Limb {
  BodyJoint parent, root, middle, end;
};

constexpr Limb arms[] = {{LeftClavicle, LeftShoulder, LeftElbow, LeftWrist},
                         {RightClavicle, RightShoulder, RightElbow, RightWrist}};
constexpr Limb legs[] = {{Pelvis, LeftHip, LeftKnee, LeftAnkle},
                         {Pelvis, RightHip, RightKnee, RightAnkle}};

BodyEnd hand(std::size_t side) { return side == 0 ? BodyEnd::left_hand : BodyEnd::right_hand; }
BodyEnd foot(std::size_t side) { return side == 0 ? BodyEnd::left_foot : BodyEnd::right_foot; }

bool is_zero(const Vec3& v) { return v.isZero(0.0); }

/// Rotates the upper of two joints in the room, the lower one by half as much.
void turn_pair(const Skeleton& body, Pose& pose, BodyJoint lower, BodyJoint upper,
               const Vec3& turn) {
  if (is_zero(turn)) return;
  const int above = body.joints[lower].parent;
  const Quat parent = world_transform(body, pose, above).rotation;
  const Quat below = parent * pose.rotations[lower];
  const Quat turned_below = exp(0.5 * turn) * below;
  const Quat turned = exp(turn) * below * pose.rotations[upper];
  pose.rotations[lower] =
      in_hemisphere_of(pose.rotations[lower], (parent.conjugate() * turned_below).normalized());
  pose.rotations[upper] =
      in_hemisphere_of(pose.rotations[upper], (turned_below.conjugate() * turned).normalized());
}

/// Where the middle joint lies off the line from root to end: where it is as long as the end does
/// not move, on the side to which the joint bends (`side`) when it does. A limb that is nearly
/// straight may be bent to the wrong side by noise.
Vec3 bend_hint(const TwoBoneLimb& limb, const Vec3& target, const Vec3& side) {
  const Vec3 line = (limb.end - limb.root).normalized();
  const Vec3 upper = limb.middle - limb.root;
  const Vec3 own = upper - upper.dot(line) * line;
  if (own.norm() < 1e-9) return side;
  const double moved = smoother_step((target - limb.end).norm() / moved_metres);
  return moved * side + (1.0 - moved) * own.normalized();
}

/// Bends a limb so that `end`, a point that turns with its lower bone, comes to `target`. `side`:
/// where the middle joint lies when the limb is bent, in the frame of the upper bone. Returns the
/// lower bone's rotation.
Quat bend_limb(Pose& pose, const JointTransforms& world, const Limb& limb, const Vec3& end,
               const Vec3& target, const Vec3& side) {
  const TwoBoneLimb bones{world.positions[limb.root], world.positions[limb.middle], end};
  const TwoBoneSolution solved =
      solve_two_bone(bones, target, bend_hint(bones, target, world.rotations[limb.root] * side));
  const Quat upper = solved.upper_turn * world.rotations[limb.root];
  const Quat lower = solved.lower_turn * world.rotations[limb.middle];
  const auto set = [&](BodyJoint joint, const Quat& parent, const Quat& rotation) {
    Quat& own = pose.rotations[joint];
    own = in_hemisphere_of(own, (parent.conjugate() * rotation).normalized());
  };
  set(limb.root, world.rotations[limb.parent], upper);
  set(limb.middle, upper, lower);
  return lower;
}

void turn_end(Pose& pose, const Limb& limb, const Quat& lower, const Quat& rotation) {
  Quat& own = pose.rotations[limb.end];
  own = in_hemisphere_of(own, (lower.conjugate() * rotation).normalized());
}

bool moves_hand(const PoseChange& change, std::size_t side) {
  return !is_zero(change.hands[side]) || !is_zero(change.swings[side]) ||
         change.stretches[side] != 0.0;
}

void swing_arm(const Skeleton& body, Pose& pose, std::size_t side, const Vec3& swing) {
  if (is_zero(swing)) return;
  const Quat parent = world_transform(body, pose, arms[side].parent).rotation;
  Quat& own = pose.rotations[arms[side].root];
  own = in_hemisphere_of(own, (parent.conjugate() * exp(swing) * parent * own).normalized());
}

void move_hand(const Skeleton& body, Pose& pose, std::size_t side, const PoseChange& change) {
  const Vec3& turn = change.hand_turns[side];
  if (!moves_hand(change, side) && is_zero(turn)) return;
  const Vec3 elbow_back = -Vec3::UnitZ();
  swing_arm(body, pose, side, change.swings[side]);
  const JointTransforms world = world_transforms(body, pose);
  const Vec3 shoulder = world.positions[arms[side].root];
  const Vec3 swung = place_of(body, world, hand(side));
  const Vec3 place =
      shoulder + std::exp(change.stretches[side]) * (swung - shoulder) + change.hands[side];
  if (moves_hand(change, side)) bend_limb(pose, world, arms[side], swung, place, elbow_back);
  if (is_zero(turn)) return;
  const JointTransforms placed = world_transforms(body, pose);
  const Quat turned = exp(turn) * placed.rotations[arms[side].end];
  const Vec3 wrist = place - turned * point_of(body, hand(side));
  const Quat lower =
      bend_limb(pose, placed, arms[side], placed.positions[arms[side].end], wrist, elbow_back);
  turn_end(pose, arms[side], lower, turned);
}

/// `before`: the joints before the pelvis moved.
void move_foot(const Skeleton& body, Pose& pose, std::size_t side, const JointTransforms& before,
               const PoseChange& change) {
  const Vec3& shift = change.feet[side];
  const Vec3& turn = change.foot_turns[side];
  if (is_zero(shift) && is_zero(turn) && is_zero(change.pelvis)) return;
  const Limb& leg = legs[side];
  const JointTransforms world = world_transforms(body, pose);
  const Quat foot_before = before.rotations[leg.end];
  const Quat turned = is_zero(turn) ? foot_before : exp(turn) * foot_before;
  const Vec3 point = point_of(body, foot(side));
  const Vec3 ankle = before.positions[leg.end] + shift +
                     (is_zero(turn) ? Vec3::Zero() : Vec3(foot_before * point - turned * point));
  const Quat lower = bend_limb(pose, world, leg, world.positions[leg.end], ankle, Vec3::UnitZ());
  turn_end(pose, leg, lower, turned);
}

bool is_nothing(const PoseChange& change) {
  const auto are_zero = [](const std::array<Vec3, 2>& pair) {
    return is_zero(pair[0]) && is_zero(pair[1]);
  };
  return is_zero(change.pelvis) && is_zero(change.trunk) && is_zero(change.gaze) &&
         !moves_hand(change, 0) && !moves_hand(change, 1) && are_zero(change.feet) &&
         are_zero(change.hand_turns) && are_zero(change.foot_turns);
}

}  // namespace

Pose changed(const Skeleton& body, const Pose& pose, const PoseChange& change) {
  if (is_nothing(change)) return pose;
  const JointTransforms before = world_transforms(body, pose);
  Pose result = pose;
  result.root_position += change.pelvis;
  turn_pair(body, result, Spine, Chest, change.trunk);
  turn_pair(body, result, Neck, Head, change.gaze);
  for (const std::size_t side : {0U, 1U}) {
    move_hand(body, result, side, change);
    move_foot(body, result, side, before, change);
  }
  return result;
}

ArmSwing swing_to(const Skeleton& body, const JointTransforms& world, bool left,
                  const Vec3& place) {
  const std::size_t side = left ? 0 : 1;
  const Vec3 shoulder = world.positions[arms[side].root];
  const Vec3 from = place_of(body, world, hand(side)) - shoulder;
  const Vec3 to = place - shoulder;
  if (from.norm() < 1e-9 || to.norm() < 1e-9) return {};
  const double stretch = std::log(to.norm() / from.norm());
  const double angle = std::atan2(from.cross(to).norm(), from.dot(to));
  const double wide = smooth_step((angle - wide_swing) / more_swing);
  if (wide == 0.0) return {log(turn_between(from, to)), stretch};
  const Vec3 front = world.rotations[Chest] * Vec3(left ? 0.3 : -0.3, 0.0, 1.0).normalized();
  const Vec3 shortest = from.normalized() + to.normalized();
  const Vec3 middle =
      (1.0 - wide) * (shortest.norm() > 1e-6 ? shortest.normalized() : front) + wide * front;
  return {log(turn_between(middle, to) * turn_between(from, middle)), stretch};
}

Vec3 lean_towards(const Skeleton& body, const JointTransforms& world, bool left, const Vec3& place,
                  double usual) {
  const std::size_t side = left ? 0 : 1;
  const Limb& arm = arms[side];
  const Vec3 shoulder = world.positions[arm.root];
  const Vec3 elbow = world.positions[arm.middle];
  const double length =
      (elbow - shoulder).norm() + (place_of(body, world, hand(side)) - elbow).norm();
  const double distance = (place - shoulder).norm();
  if (distance <= bent_arm * length) return Vec3::Zero();
  const auto bent = [&](double metres) {
    return smoothly_limited(metres, (bent_arm + more_extension) * length, more_extension * length);
  };
  const double wanted = std::min(bent(distance) + usual - bent(usual), most_extension * length);
  const Vec3 arm_root = shoulder - world.positions[Spine];
  const Vec3 goal = place - world.positions[Spine];
  const Vec3 axis = arm_root.cross(goal);
  if (axis.norm() < 1e-9) return Vec3::Zero();
  const double r = arm_root.norm(), d = goal.norm();
  const double angle = std::atan2(axis.norm(), arm_root.dot(goal));
  const double cosine = (r * r + d * d - wanted * wanted) / (2.0 * r * d);
  const double more = std::max(0.0, angle - std::acos(std::clamp(cosine, -1.0, 1.0)));
  return more * more * more / (more * more + little_lean * little_lean) * axis.normalized();
}

double usual_reach(const Skeleton& body, const JointTransforms& world, bool left) {
  const std::size_t side = left ? 0 : 1;
  return (place_of(body, world, hand(side)) - world.positions[arms[side].root]).norm();
}

Vec3 bounded_lean(const Vec3& lean) {
  const double angle = lean.norm();
  return angle < 1e-12 ? lean : Vec3(most_lean * std::tanh(angle / most_lean) / angle * lean);
}

double usual_extension(const JointTransforms& world, bool left) {
  const Limb& leg = legs[left ? 0 : 1];
  return (world.positions[leg.end] - world.positions[leg.root]).norm();
}

Vec3 shift_towards(const Skeleton& body, const JointTransforms& world, bool left, const Vec3& place,
                   double usual) {
  const std::size_t side = left ? 0 : 1;
  const Limb& leg = legs[side];
  const Vec3 ankle = place - world.rotations[leg.end] * point_of(body, foot(side));
  const Vec3 way = ankle - world.positions[leg.root];
  const double length = body.joints[leg.middle].offset.norm() + body.joints[leg.end].offset.norm();
  const double missing = way.norm() - std::max(straight_leg * length, usual);
  if (missing <= 0.0) return Vec3::Zero();
  return std::min(missing, most_shift) * way.normalized();
}

}  // namespace mien::motion
