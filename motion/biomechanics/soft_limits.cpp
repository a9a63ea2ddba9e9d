#include "motion/biomechanics/soft_limits.h"

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
  std::string_view angle;  ///< empty for a wrist, which has one limit in all directions
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

double side_of(BodyJoint joint, const LimitedTurn& turn) {
  return is_right(joint) && turn.axis > 0 ? -1.0 : 1.0;
}

double turned(const Pose& pose, BodyJoint joint, const LimitedTurn& turn) {
  return side_of(joint, turn) * log(pose.rotations[static_cast<size_t>(joint)])[turn.axis];
}

/// Bends one joint back; by how much, radians.
double limit_joint(Pose& pose, BodyJoint joint, const LimitedTurn& turn,
                   const TurnExtremes::Extreme& known) {
  const TurnRange range = range_of(turn);
  const double before = turned(pose, joint, turn);
  double after = limit_above(before, range.most * radians_per_degree, known.most,
                             range.most == 0.0 ? hinge_room_deg : soft_room_deg);
  after = -limit_above(-after, -range.least * radians_per_degree, -known.least,
                       range.least == 0.0 ? hinge_room_deg : soft_room_deg);
  if (after == before) return 0.0;
  Quat& rotation = pose.rotations[static_cast<size_t>(joint)];
  Vec3 turn_vector = log(rotation);
  turn_vector[turn.axis] = side_of(joint, turn) * after;
  rotation = in_hemisphere_of(rotation, exp(turn_vector));
  return std::abs(after - before);
}

/// Each limited turn on the left, then on the right.
template <typename Visit>
void for_each_turn(const Visit& visit) {
  size_t i = 0;
  for (const LimitedTurn& turn : limited_turns) {
    visit(i++, turn.left_joint, turn);
    visit(i++, mirrored(turn.left_joint), turn);
  }
}

}  // namespace

void widen(TurnExtremes& extremes, const Pose& pose) {
  const bool first = extremes.turns.empty();
  if (first) extremes.turns.resize(2 * limited_turns.size());
  for_each_turn([&](size_t i, BodyJoint joint, const LimitedTurn& turn) {
    const double value = turned(pose, joint, turn);
    TurnExtremes::Extreme& known = extremes.turns[i];
    known = first
                ? TurnExtremes::Extreme{value, value}
                : TurnExtremes::Extreme{std::min(known.least, value), std::max(known.most, value)};
  });
}

double limit_softly(Pose& pose, const TurnExtremes& known) {
  double largest = 0.0;
  for_each_turn([&](size_t i, BodyJoint joint, const LimitedTurn& turn) {
    largest = std::max(largest, limit_joint(pose, joint, turn, known.turns[i]));
  });
  return largest;
}

double softly_limited(double value, double start, double limit) {
  if (value <= start) return value;
  const double room = limit - start;
  return start + room * (1.0 - std::exp(-(value - start) / room));
}

SoftLimits with_soft_limits(const Clip& clip, const Clip& original) {
  SoftLimits result{clip, 0.0};
  if (clip.poses.empty() || original.poses.empty()) return result;
  TurnExtremes known;
  for (const Pose& pose : original.poses) widen(known, pose);
  for (Pose& pose : result.clip.poses) {
    result.largest_excess = std::max(result.largest_excess, limit_softly(pose, known));
  }
  return result;
}

}  // namespace mien::motion
