#include "motion/modify/relative_change.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

#include "motion/biomechanics/joint_angles.h"
#include "motion/error.h"
#include "motion/gestures/acting_hand.h"
#include "motion/math/filter.h"
#include "motion/math/rotation.h"
#include "motion/modify/feet_apart.h"
#include "motion/modify/turn_curve.h"
#include "motion/modify/value_range.h"
#include "motion/skeleton/straighten.h"

namespace mien::motion {

namespace {

constexpr double most_factor = 3.0;
constexpr double most_step_length = 2.0;  // longer legs than that are not reached
constexpr double course_hz = 0.3;         // of a motion that does not loop
constexpr double swing_hz = 6.0;          // above it, a capture's noise is not swing

/// The angle of joint_angles.h that a unit changes.
struct UnitAngle {
  PostureUnit unit;
  BodyJoint joint;  ///< of the left side
  std::string_view angle;
  double sign = 1.0;      ///< −1: the angle falls when the unit's rises
  double least = -360.0;  ///< degrees; a narrower limit than that of the joint
};

constexpr std::array<UnitAngle, 9> unit_angles = {{
    {PostureUnit::head_flexion, Head, "flexion"},
    {PostureUnit::chest_flexion, Chest, "flexion"},
    {PostureUnit::spine_flexion, Chest, "flexion"},
    {PostureUnit::shoulder_abduction, LeftShoulder, "adduction", -1.0, 0.0},
    {PostureUnit::shoulder_flexion, LeftShoulder, "extension", -1.0},
    {PostureUnit::elbow_flexion, LeftElbow, "flexion"},
    {PostureUnit::hip_flexion, LeftHip, "flexion"},
    {PostureUnit::knee_flexion, LeftKnee, "flexion"},
    {PostureUnit::ankle_dorsiflexion, LeftAnkle, "dorsiflexion"},
}};

/// Of what is asked of arms and of the swing of the trunk, the part that they take when a hand
/// makes a gesture: the other arm rests and goes with the body, and the trunk turns and bends with
/// the gesture, once, instead of swinging.
constexpr double share_in_gestures = 0.35;

bool turns_arm(PostureUnit unit) {
  return unit == PostureUnit::shoulder_abduction || unit == PostureUnit::shoulder_flexion ||
         unit == PostureUnit::elbow_flexion;
}

const UnitAngle* angle_of(PostureUnit unit) {
  const auto found = std::find_if(unit_angles.begin(), unit_angles.end(),
                                  [&](const UnitAngle& each) { return each.unit == unit; });
  return found == unit_angles.end() ? nullptr : &*found;
}

size_t index_of(BodyJoint joint, std::string_view name) {
  return static_cast<size_t>(&joint_angle(joint, name) - joint_angles().data());
}

/// The abduction of each hip, degrees, that brings the feet `metres` farther apart.
double abduction_for(double metres, const Skeleton& body) {
  const double share = std::clamp(0.5 * metres / leg_length(body), -1.0, 1.0);
  return std::asin(share) / radians_per_degree;
}

/// Beyond its ends a motion is taken to go back the way it came: where it starts in the middle of a
/// step, what it swings about is found from that step, and not taken to be where it starts.
std::vector<Vec3> course_of(const std::vector<Vec3>& turns, const Clip& clip) {
  if (clip.loops) return std::vector<Vec3>(turns.size(), Vec3::Zero());
  std::vector<Vec3> there_and_back(turns.rbegin(), turns.rend());
  there_and_back.insert(there_and_back.end(), turns.begin(), turns.end());
  there_and_back.insert(there_and_back.end(), turns.rbegin(), turns.rend());
  const std::vector<Vec3> course = low_pass(there_and_back, course_hz, clip.frames_per_second);
  const auto first = course.begin() + static_cast<std::ptrdiff_t>(turns.size());
  return {first, first + static_cast<std::ptrdiff_t>(turns.size())};
}

/// The frame in which the knee is straightest.
size_t straightest_frame(const Clip& clip, BodyJoint knee) {
  const size_t flexion = index_of(knee, "flexion");
  size_t frame = 0;
  double least = std::numeric_limits<double>::infinity();
  for (size_t f = 0; f < clip.poses.size(); ++f) {
    const double angle = measured_angles(clip.poses[f])[flexion];
    if (angle < least) frame = f;
    least = std::min(least, angle);
  }
  return frame;
}

/// What the swing of a joint deviates from.
std::vector<Vec3> rest_of_swing(const TurnCurve& curve, const Clip& clip, BodyJoint joint) {
  const bool is_knee = joint == LeftKnee || joint == RightKnee;
  if (!clip.loops || !is_knee) return course_of(curve.turns, clip);
  return std::vector<Vec3>(curve.turns.size(), curve.turns[straightest_frame(clip, joint)]);
}

void multiply_swing(Clip& clip, BodyJoint joint, double factor) {
  TurnCurve curve = turn_curve(clip, joint);
  const std::vector<Vec3> course = rest_of_swing(curve, clip, joint);
  const std::vector<Vec3> swing = low_pass(curve.turns, swing_hz, clip.frames_per_second,
                                           clip.loops ? SignalEnds::periodic : SignalEnds::open);
  for (size_t f = 0; f < curve.turns.size(); ++f)
    curve.turns[f] += (factor - 1.0) * (swing[f] - course[f]);
  set_rotations(clip, joint, curve);
}

/// Lateral deviation of the pelvis from its way, metres to the left of its heading, frame by frame.
std::vector<double> lateral_sway(const Clip& clip) {
  const Vec3 to_left = Vec3::UnitY().cross(mean_direction(clip));
  std::vector<double> sway;
  for (const Pose& pose : clip.poses) sway.push_back(pose.root_position.dot(to_left));
  const double count = static_cast<double>(sway.size());
  const double step = clip.loops ? clip.cycle_displacement.dot(to_left) / count : 0.0;
  for (size_t f = 0; f < sway.size(); ++f) sway[f] -= static_cast<double>(f) * step;
  if (!clip.loops) {
    const std::vector<double> course = low_pass(sway, course_hz, clip.frames_per_second);
    for (size_t f = 0; f < sway.size(); ++f) sway[f] -= course[f];
    return sway;
  }
  const double mean = std::accumulate(sway.begin(), sway.end(), 0.0) / count;
  for (double& each : sway) each -= mean;
  return sway;
}

void multiply_sway(Clip& clip, double factor) {
  const std::vector<double> sway = lateral_sway(clip);
  for (size_t f = 0; f < clip.poses.size(); ++f) {
    const double lean = std::atan2((factor - 1.0) * sway[f], leg_length(clip.body));
    for (const BodyJoint hip : {LeftHip, RightHip}) {
      Quat& rotation = clip.poses[f].rotations[hip];
      rotation = (exp(Vec3(0.0, 0.0, -lean)) * rotation).normalized();
    }
  }
}

}  // namespace

std::optional<UnitRange> range_of(PostureUnit unit) {
  const UnitAngle* what = angle_of(unit);
  if (what == nullptr) return std::nullopt;
  const JointAngle& angle = joint_angle(what->joint, what->angle);
  const UnitRange range = what->sign > 0.0
                              ? UnitRange{angle.least_degrees, angle.most_free_degrees}
                              : UnitRange{-angle.most_free_degrees, -angle.least_degrees};
  return UnitRange{std::max(range.least, what->least), range.most};
}

double own_angle(const Clip& clip, PostureUnit unit) {
  const UnitAngle* what = angle_of(unit);
  assert(what != nullptr);
  const size_t left = index_of(what->joint, what->angle);
  const size_t right = index_of(mirrored(what->joint), what->angle);
  double sum = 0.0;
  for (const Pose& pose : clip.poses) {
    const std::vector<double> angles = measured_angles(pose);
    sum += 0.5 * (angles[left] + angles[right]);
  }
  return what->sign * sum / clip.frame_count();
}

bool is_identity(const RelativeChange& change) {
  return change.step_width == 1.0 && !changes_swing(change) &&
         std::all_of(change.range.begin(), change.range.end(),
                     [](const RangeShare& each) { return each.share == 0.0; });
}

bool changes_swing(const RelativeChange& change) {
  return change.step_length != 1.0 || change.sway != 1.0 || change.arm_swing != 1.0 ||
         change.trunk_swing != 1.0;
}

RelativeChange without_swing(RelativeChange change) {
  change.step_length = change.sway = change.arm_swing = change.trunk_swing = 1.0;
  return change;
}

RelativeChange scaled(RelativeChange change, double strength) {
  const auto power = [&](double factor, double most) {
    return std::clamp(std::pow(factor, strength), 0.0, most);
  };
  change.step_width = power(change.step_width, most_factor);
  change.step_length = power(change.step_length, most_step_length);
  change.sway = power(change.sway, most_factor);
  change.arm_swing = power(change.arm_swing, most_factor);
  change.trunk_swing = power(change.trunk_swing, most_factor);
  for (RangeShare& each : change.range) each.share = std::clamp(strength * each.share, -1.0, 1.0);
  return change;
}

void check(const RelativeChange& change) {
  check_range("step_width", change.step_width, 0.0, most_factor);
  check_range("step_length", change.step_length, 0.0, most_step_length);
  check_range("sway", change.sway, 0.0, most_factor);
  check_range("arm_swing", change.arm_swing, 0.0, most_factor);
  check_range("trunk_swing", change.trunk_swing, 0.0, most_factor);
  for (const RangeShare& each : change.range) {
    const std::string name(name_of(each.unit));
    if (!range_of(each.unit)) {
      throw Error("the range of " + name + " is not known", "give it in degrees, as posture");
    }
    check_range("range." + name, each.share, -1.0, 1.0);
  }
}

std::vector<PostureChange> posture_of(const RelativeChange& change, const Clip& clip,
                                      std::span<const FootPlant> plants) {
  std::vector<PostureChange> posture;
  const bool gestures = acting_hand(clip).has_value();
  for (const auto& [unit, share] : change.range) {
    const UnitRange range = *range_of(unit);
    const double own = own_angle(clip, unit);
    const double free = share > 0.0 ? range.most - own : own - range.least;
    const double part = gestures && turns_arm(unit) ? share_in_gestures : 1.0;
    posture.push_back({unit, part * share * std::max(0.0, free)});
  }
  if (change.step_width == 1.0) return posture;
  const std::optional<double> own = mean_step_width(clip, plants);
  if (!own) return posture;
  const double narrowest = std::min(*own, foot_width(clip.body));
  const double width = std::max(narrowest, change.step_width * *own);
  posture.push_back({PostureUnit::hip_abduction, abduction_for(width - *own, clip.body)});
  return posture;
}

Clip with_swing(const Clip& clip, const RelativeChange& change) {
  Clip result = clip;
  if (change.trunk_swing != 1.0) {
    const double factor =
        acting_hand(clip) ? std::pow(change.trunk_swing, share_in_gestures) : change.trunk_swing;
    for (const BodyJoint joint : {Pelvis, Spine, Chest, Neck, Head})
      multiply_swing(result, joint, factor);
    for (size_t f = 0; f < result.poses.size(); ++f) {
      Pose& pose = result.poses[f];
      const Quat turned = pose.rotations[Pelvis].conjugate() * clip.poses[f].rotations[Pelvis];
      for (const BodyJoint hip : {LeftHip, RightHip})
        pose.rotations[hip] = (turned * pose.rotations[hip]).normalized();
    }
  }
  if (change.sway != 1.0) multiply_sway(result, change.sway);
  if (change.step_length != 1.0) {
    for (const BodyJoint joint : {LeftHip, LeftKnee, LeftAnkle})
      for (const BodyJoint each : {joint, mirrored(joint)})
        multiply_swing(result, each, change.step_length);
  }
  if (change.arm_swing != 1.0 && (clip.loops || is_locomotion(clip))) {
    for (const BodyJoint joint : {LeftClavicle, LeftShoulder, LeftElbow, LeftWrist})
      for (const BodyJoint each : {joint, mirrored(joint)})
        multiply_swing(result, each, change.arm_swing);
  }
  return result;
}

}  // namespace mien::motion
