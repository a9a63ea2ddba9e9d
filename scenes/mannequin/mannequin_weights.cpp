#include "scenes/mannequin/mannequin_weights.h"

#include <algorithm>
#include <array>

#include "motion/skeleton/body.h"
#include "scenes/mannequin/mannequin_hand.h"
#include "scenes/mannequin/mannequin_landmarks.h"

namespace mien::scenes {

namespace {

using motion::BodyJoint;
using motion::smooth_step;
using motion::Vec3;

/// A joint along a limb and half the length of the zone over which it takes over, at 1.75 m.
struct Hinge {
  BodyJoint joint;
  double reach;
  double ahead = 0.0;  ///< the zone's middle lies so far beyond the joint, metres at 1.75 m
};

constexpr std::array<Hinge, 4> trunk_hinges = {{{motion::Spine, 0.075},
                                                {motion::Chest, 0.085},
                                                {motion::Neck, 0.040},
                                                {motion::Head, 0.040, -0.005}}};
constexpr std::array<Hinge, 3> arm_hinges = {
    {{motion::LeftShoulder, 0.055, 0.005}, {motion::LeftElbow, 0.045}, {motion::LeftWrist, 0.030}}};
constexpr std::array<Hinge, 4> leg_hinges = {{{motion::LeftHip, 0.085, 0.02},
                                              {motion::LeftKnee, 0.060},
                                              {motion::LeftAnkle, 0.035},
                                              {motion::LeftToe, 0.028, -0.01}}};

using Weights = std::array<double, motion::body_joint_count + motion::finger_joint_count>;

struct Weigher {
  const motion::Skeleton& body;
  const motion::JointTransforms& pose;
  Trunk trunk;
  HeadShape head;
  double scale;
  Vec3 point;

  Vec3 at(BodyJoint joint) const { return pose.positions[joint]; }

  /// Direction of the bone that the joint carries.
  Vec3 bone(BodyJoint joint) const {
    return (pose.rotations[joint] * motion::rest_direction(joint)).normalized();
  }

  /// 0 well before the joint, 1 well beyond it in that direction.
  double beyond(const Hinge& hinge, BodyJoint joint, const Vec3& direction) const {
    const double distance = direction.dot(point - at(joint)) / scale - hinge.ahead;
    return smooth_step(0.5 + 0.5 * distance / hinge.reach);
  }

  /// 0 well before the joint, 1 well beyond it, across the plane that halves the bend.
  double beyond(const Hinge& hinge, BodyJoint joint) const {
    if (joint == motion::Head) {
      // The whole skull goes with the head, and so does the jaw though it lies lower than the
      // joint.
      const motion::Quat& turn = pose.rotations[motion::Head];
      const double skull = beyond(hinge, joint, turn * Vec3::UnitY());
      const double jaw = beyond(hinge, joint, turn * Vec3(0.0, 0.6, 0.8));
      return skull + jaw - skull * jaw;
    }
    const Vec3 before = bone(BodyJoint(motion::body_parents[joint]));
    const bool branches = joint == motion::LeftHip || joint == motion::RightHip;
    return beyond(hinge, joint, branches ? bone(joint) : (before + bone(joint)).normalized());
  }
};

/// A hinge of the trunk or head where there is flesh to bend: rigs have joints of the spine in the
/// pelvis or at the neck, and the joint of the head above the jaw.
Hinge set_in_flesh(const Weigher& weigher, Hinge hinge) {
  const double hips = weigher.trunk.hips.y();
  const double shoulders = weigher.trunk.shoulders.y();
  const double joint = weigher.at(hinge.joint).y();
  const double scale = weigher.scale;
  if (hinge.joint == motion::Head) {
    hinge.ahead += 0.6 * std::min(weigher.head.raise.y(), 0.0) / scale;
  } else if (hinge.joint == motion::Neck) {
    hinge.ahead += std::max(shoulders + 0.05 * scale - joint, 0.0) / scale;
  } else {
    const double lowest = hips + 0.06 * scale;
    const double highest = std::max(shoulders - 0.12 * scale, lowest);
    hinge.ahead += (std::clamp(joint, lowest, highest) - joint) / scale;
  }
  return hinge;
}

/// Shares `share` of the point out along a chain: from `base`, each hinge taking over from the
/// last.
template <size_t count>
void share_along(const Weigher& weigher, BodyJoint base, const std::array<Hinge, count>& hinges,
                 int side_shift, double share, Weights& weights) {
  double left = share;
  auto holder = static_cast<size_t>(base);
  for (const Hinge& hinge : hinges) {
    const auto joint = BodyJoint(hinge.joint + side_shift);
    const double beyond = weigher.beyond(hinge, joint);
    weights[holder] += left * (1.0 - beyond);
    left *= beyond;
    holder = static_cast<size_t>(joint);
  }
  weights[holder] += left;
}

double distance_to_segment(const Vec3& point, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const double t =
      std::clamp((point - a).dot(along) / std::max(along.squaredNorm(), 1e-12), 0.0, 1.0);
  return (point - a - t * along).norm();
}

/// The flesh round the collar bone goes with it, away from the neck.
void weight_to_clavicle(const Weigher& weigher, BodyJoint clavicle, Weights& weights) {
  const auto shoulder = BodyJoint(clavicle + 1);
  const Vec3 along = weigher.at(shoulder) - weigher.at(clavicle);
  const double length = along.norm();
  if (length < 1e-6) return;
  const double outward = (weigher.point - weigher.at(clavicle)).dot(along) / (length * length);
  const double near =
      distance_to_segment(weigher.point, weigher.at(clavicle), weigher.at(shoulder));
  const double share =
      smooth_step((outward - 0.15) / 0.6) * smooth_step((0.17 - near / weigher.scale) / 0.11);
  for (const BodyJoint from : {motion::Spine, motion::Chest, motion::Neck}) {
    weights[clavicle] += share * weights[from];
    weights[from] *= 1.0 - share;
  }
}

/// The fingers take over from the wrist.
void share_along_fingers(const Weigher& weigher, Weights& weights) {
  const double scale = hand_scale(weigher.body);
  const std::vector<Vec3> fingertips = fingertips_of(weigher.body, weigher.pose);
  for (const BodyJoint wrist : {motion::LeftWrist, motion::RightWrist}) {
    const double held = weights[wrist];
    if (held == 0.0) continue;
    const bool left = motion::is_left(wrist);
    const auto shares = finger_shares(weigher.pose, fingertips, left, scale, weigher.point);
    const int first = with_body(motion::finger_joint(left, motion::Finger::thumb, 0));
    for (std::size_t j = 0; j < shares.size(); ++j) {
      weights[static_cast<std::size_t>(first) + j] = held * shares[j];
      weights[wrist] -= held * shares[j];
    }
  }
}

/// How much a point belongs to a limb rather than to the trunk; and to neither of two limbs that
/// are equally near.
double share_of_limb(double trunk, double limb, double other_limb, double scale) {
  constexpr double zone = 0.070;
  constexpr double shift = 0.010;
  constexpr double between = 0.060;
  const double from_trunk =
      smooth_step(0.5 + 0.5 * (trunk - limb + shift * scale) / (zone * scale));
  return from_trunk * smooth_step((other_limb - limb) / (between * scale));
}

}  // namespace

std::vector<Influence> mannequin_weights(const motion::Skeleton& body,
                                         const motion::JointTransforms& pose, const Flesh& flesh,
                                         const Vec3& point) {
  const Weigher weigher{
      body, pose, trunk_of(body, pose), head_shape(body), motion::relative_stature(body), point};
  const auto [trunk, left_arm, right_arm, left_leg, right_leg] = limb_distances(flesh, point);
  const double to_left_arm = share_of_limb(trunk, left_arm, right_arm, weigher.scale);
  const double to_right_arm = share_of_limb(trunk, right_arm, left_arm, weigher.scale);
  const double to_left_leg = share_of_limb(trunk, left_leg, right_leg, weigher.scale);
  const double to_right_leg = share_of_limb(trunk, right_leg, left_leg, weigher.scale);
  const bool is_leg = std::min(left_leg, right_leg) < std::min(left_arm, right_arm);
  const double arms = is_leg ? 0.0 : to_left_arm + to_right_arm;
  const double legs = is_leg ? to_left_leg + to_right_leg : 0.0;
  Weights trunk_weights{};
  auto hinges = trunk_hinges;
  for (Hinge& hinge : hinges) hinge = set_in_flesh(weigher, hinge);
  share_along(weigher, motion::Pelvis, hinges, 0, 1.0, trunk_weights);
  for (const BodyJoint clavicle : {motion::LeftClavicle, motion::RightClavicle}) {
    weight_to_clavicle(weigher, clavicle, trunk_weights);
  }
  Weights weights{};
  for (size_t j = 0; j < weights.size(); ++j) weights[j] = (1.0 - arms - legs) * trunk_weights[j];
  constexpr int arm_shift = motion::RightShoulder - motion::LeftShoulder;
  constexpr int leg_shift = motion::RightHip - motion::LeftHip;
  if (is_leg) {
    share_along(weigher, motion::Pelvis, leg_hinges, 0, to_left_leg, weights);
    share_along(weigher, motion::Pelvis, leg_hinges, leg_shift, to_right_leg, weights);
  } else {
    share_along(weigher, motion::LeftClavicle, arm_hinges, 0, to_left_arm, weights);
    share_along(weigher, motion::RightClavicle, arm_hinges, arm_shift, to_right_arm, weights);
  }
  if (includes_fingers(pose)) share_along_fingers(weigher, weights);
  std::vector<Influence> influences;
  for (std::size_t j = 0; j < weights.size(); ++j) {
    if (weights[j] > 0.0)
      influences.push_back({static_cast<int>(j), static_cast<float>(weights[j])});
  }
  normalize(influences);
  return influences;
}

}  // namespace mien::scenes
