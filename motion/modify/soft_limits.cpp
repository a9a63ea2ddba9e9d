#include "motion/modify/soft_limits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "motion/biomechanics/joint_angles.h"
#include "motion/math/rotation.h"

namespace mien::motion {

namespace {

constexpr double margin_deg = 15.0;
constexpr double soft_room_deg = 12.0;  // beyond what the original does, before the stop
constexpr double hinge_room_deg = 3.0;  // likewise for a knee or elbow that gets straight

/// A component of a joint's rotation vector on the left side and the angle that it is, or the other
/// way round. On the right the second and third components have the other sign.
struct LimitedTurn {
  BodyJoint left_joint;
  int axis;
  double sign;
  std::string_view angle;  ///< none of a wrist, which bends alike to all sides
};

constexpr std::array<LimitedTurn, 8> limited_turns = {{
    {LeftHip, 0, -1.0, "flexion"},
    {LeftHip, 2, 1.0, "abduction"},
    {LeftKnee, 0, 1.0, "flexion"},
    {LeftAnkle, 0, -1.0, "dorsiflexion"},
    {LeftElbow, 1, -1.0, "flexion"},
    {LeftWrist, 0, 1.0, ""},
    {LeftWrist, 1, 1.0, ""},
    {LeftWrist, 2, 1.0, ""},
}};

/// Degrees of the component.
struct TurnRange {
  double least;
  double most;
};

TurnRange range_of(const LimitedTurn& turn) {
  if (turn.angle.empty()) return {-wrist_range_degrees, wrist_range_degrees};
  const JointAngle& angle = joint_angle(turn.left_joint, turn.angle);
  if (turn.sign < 0.0) return {-angle.most_free_degrees, -angle.least_degrees};
  return {angle.least_degrees, angle.most_free_degrees};
}

/// Bends the values back that come near `limit` from below, as far as `known` values did not.
double limit_above(double value, double limit, double known, double room) {
  const double start = std::max(limit - margin_deg * radians_per_degree, known);
  if (value <= start) return value;
  const double end = std::max(limit, start + room * radians_per_degree);
  return softly_limited(value, start, end);
}

void limit_joint(SoftLimits& result, const Clip& original, BodyJoint joint,
                 const LimitedTurn& turn) {
  const auto at = static_cast<size_t>(joint);
  const double side = is_right(joint) && turn.axis > 0 ? -1.0 : 1.0;
  const TurnRange range = range_of(turn);
  const auto value = [&](const Pose& pose) { return side * log(pose.rotations[at])[turn.axis]; };
  double least = value(original.poses.front());
  double most = least;
  for (const Pose& pose : original.poses) {
    const double known = value(pose);
    least = std::min(least, known);
    most = std::max(most, known);
  }
  for (Pose& pose : result.clip.poses) {
    const double before = value(pose);
    double after = limit_above(before, range.most * radians_per_degree, most,
                               range.most == 0.0 ? hinge_room_deg : soft_room_deg);
    after = -limit_above(-after, -range.least * radians_per_degree, -least,
                         range.least == 0.0 ? hinge_room_deg : soft_room_deg);
    if (after == before) continue;
    Vec3 turned = log(pose.rotations[at]);
    turned[turn.axis] = side * after;
    pose.rotations[at] = in_hemisphere_of(pose.rotations[at], exp(turned));
    result.largest_excess = std::max(result.largest_excess, std::abs(after - before));
  }
}

}  // namespace

double softly_limited(double value, double start, double limit) {
  if (value <= start) return value;
  const double room = limit - start;
  return start + room * (1.0 - std::exp(-(value - start) / room));
}

SoftLimits with_soft_limits(const Clip& clip, const Clip& original) {
  SoftLimits result{clip, 0.0};
  if (clip.poses.empty() || original.poses.empty()) return result;
  for (const LimitedTurn& turn : limited_turns) {
    limit_joint(result, original, turn.left_joint, turn);
    limit_joint(result, original, mirrored(turn.left_joint), turn);
  }
  return result;
}

}  // namespace mien::motion
