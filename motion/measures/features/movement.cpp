#include "motion/measures/features/movement.h"

#include <algorithm>
#include <cmath>

#include "motion/error.h"
#include "motion/math/filter.h"
#include "motion/skeleton/hand_tip.h"

namespace mien::motion {

namespace {

constexpr double cutoff_hz = 6.0;
constexpr double heading_cutoff_hz = 0.5;
constexpr double heading_seconds = 2.0;  ///< shorter clips have one heading
constexpr double loop_seconds = 4.0;
constexpr int fewest_samples = 8;
double angle_of_bend(const Vec3& upper, const Vec3& lower) {
  return std::atan2(upper.cross(lower).norm(), upper.dot(lower));
}
Clip even_samples(const Clip& clip) {
  Clip even = clip;
  if (clip.loops) {
    const double seconds = std::max(clip.duration_seconds(), 1e-3);
    even = repeated(clip, std::max(1, static_cast<int>(std::ceil(loop_seconds / seconds))));
  }
  even = resampled(even, movement_samples_per_second);
  if (!is_body(even.body) || even.frame_count() < fewest_samples)
    throw Error(clip.name + ": the motion is too short to be measured, or not of a human body",
                "give a motion of 0.3 s or more");
  return even;
}

void set_directions(Movement& m) {
  for (std::size_t f = 0; f < m.joints[Pelvis].size(); ++f)
    m.left.push_back(horizontal(m.between(RightHip, LeftHip, f)).normalized() +
                     horizontal(m.between(RightShoulder, LeftShoulder, f)).normalized());
  if (static_cast<double>(m.left.size()) < heading_seconds * movement_samples_per_second) {
    Vec3 sum = Vec3::Zero();
    for (const Vec3& left : m.left) sum += left;
    m.left.assign(m.left.size(), sum);
  } else {
    m.left = low_pass(m.left, heading_cutoff_hz, movement_samples_per_second);
  }
  for (Vec3& left : m.left) {
    left = left.norm() > 1e-6 ? left.normalized() : Vec3::UnitX();
    m.forward.push_back(left.cross(Vec3::UnitY()));
  }
}

/// Value of a limb's curve on one side; outwards is positive.
double limb_value(const Movement& m, MovementCurve curve, bool is_left, std::size_t f) {
  const auto side = [is_left](BodyJoint joint) { return is_left ? joint : mirrored(joint); };
  const double out = is_left ? 1.0 : -1.0;
  const Vec3 hand = m.own((is_left ? m.left_hand : m.right_hand)[f] - m.joints[Pelvis][f], f);
  const Vec3 ankle = m.own(m.between(Pelvis, side(LeftAnkle), f), f);
  const Vec3 arm = m.own(m.between(side(LeftShoulder), side(LeftElbow), f), f);
  const Vec3 shoulder = m.own(m.between(Neck, side(LeftShoulder), f), f);
  switch (curve) {
    case HandForward:
      return hand.x();
    case HandUp:
      return hand.y();
    case HandOut:
      return out * hand.z();
    case AnkleForward:
      return ankle.x();
    case AnkleUp:
      return ankle.y();
    case AnkleOut:
      return out * ankle.z();
    case UpperArmOut:
      return std::atan2(out * arm.z(), -arm.y());
    case ElbowBend:
      return angle_of_bend(m.between(side(LeftShoulder), side(LeftElbow), f),
                           m.between(side(LeftElbow), side(LeftWrist), f));
    case KneeBend:
      return angle_of_bend(m.between(side(LeftHip), side(LeftKnee), f),
                           m.between(side(LeftKnee), side(LeftAnkle), f));
    case ShoulderUp:
      return shoulder.y();
    default:
      return shoulder.x();
  }
}

/// Value of a curve of the trunk.
double trunk_value(const Movement& m, MovementCurve curve, std::size_t f) {
  const Vec3 trunk = m.own(m.between(Pelvis, Neck, f), f);
  const Vec3 head = m.own(m.between(Neck, Head, f), f);
  const Vec3 shoulders = m.own(m.between(RightShoulder, LeftShoulder, f), f);
  const Vec3 hips = m.own(m.between(RightHip, LeftHip, f), f);
  switch (curve) {
    case TrunkForward:
      return std::atan2(trunk.x(), trunk.y());
    case TrunkSideways:
      return std::atan2(trunk.z(), trunk.y());
    case HeadForward:
      return std::atan2(head.x(), head.y());
    case HeadSideways:
      return std::atan2(head.z(), head.y());
    case ShoulderTurn:
      return std::atan2(-shoulders.x(), shoulders.z());
    case HipTurn:
      return std::atan2(-hips.x(), hips.z());
    case ShoulderRoll:
      return std::atan2(shoulders.y(), shoulders.z());
    case HipRoll:
      return std::atan2(hips.y(), hips.z());
    default:
      return m.joints[Pelvis][f].y();
  }
}

}  // namespace

void unwrap(Curve& angles) {
  for (std::size_t i = 1; i < angles.size(); ++i)
    angles[i] += 2.0 * pi * std::round((angles[i - 1] - angles[i]) / (2.0 * pi));
}

Movement sampled_movement(const Clip& original) {
  const Clip clip = even_samples(original);
  const auto frames = joint_paths(clip);
  Movement m;
  const double size = standing_height(clip.body);
  for (std::size_t j = 0; j < body_joint_count; ++j) {
    Path path;
    for (const auto& at : frames) path.push_back(at[j] / size);
    m.joints.push_back(low_pass(path, cutoff_hz, movement_samples_per_second));
  }
  for (const bool left : {true, false}) {
    Path tips;
    for (const Pose& pose : clip.poses) tips.push_back(hand_tip(clip.body, pose, left) / size);
    (left ? m.left_hand : m.right_hand) = low_pass(tips, cutoff_hz, movement_samples_per_second);
  }
  set_directions(m);
  return m;
}

std::vector<Curve> curves_of(const Movement& m, MovementCurve curve) {
  std::vector<Curve> sides(curve < HandForward ? 1 : 2);
  for (std::size_t side = 0; side < sides.size(); ++side) {
    for (std::size_t f = 0; f < m.count(); ++f)
      sides[side].push_back(sides.size() == 1 ? trunk_value(m, curve, f)
                                              : limb_value(m, curve, side == 0, f));
    unwrap(sides[side]);
  }
  return sides;
}
}  // namespace mien::motion
