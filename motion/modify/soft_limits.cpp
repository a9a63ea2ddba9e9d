#include "motion/modify/soft_limits.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "motion/math/rotation.h"

namespace mien::motion {

namespace {

constexpr double margin_deg = 15.0;
constexpr double soft_room_deg = 12.0;  // beyond what the original does, before the stop
constexpr double hinge_room_deg = 3.0;  // likewise for a knee or elbow that gets straight

/// Range of one component of a joint's rotation vector on the left side, degrees. On the right the
/// second and third components have the other sign.
struct JointRange {
  BodyJoint left_joint;
  int axis;
  double least;
  double most;
};

constexpr std::array<JointRange, 8> joint_ranges = {{
    {LeftHip, 0, -125.0, 25.0},
    {LeftHip, 2, -30.0, 45.0},
    {LeftKnee, 0, 0.0, 145.0},
    {LeftAnkle, 0, -25.0, 50.0},
    {LeftElbow, 1, -150.0, 0.0},
    {LeftWrist, 0, -80.0, 80.0},
    {LeftWrist, 1, -80.0, 80.0},
    {LeftWrist, 2, -80.0, 80.0},
}};

/// Bends the values back that come near `limit` from below, as far as `known` values did not.
double limit_above(double value, double limit, double known, double room) {
  const double start = std::max(limit - margin_deg * radians_per_degree, known);
  if (value <= start) return value;
  const double end = std::max(limit, start + room * radians_per_degree);
  return softly_limited(value, start, end);
}

void limit_joint(SoftLimits& result, const Clip& original, BodyJoint joint,
                 const JointRange& range) {
  const auto at = static_cast<size_t>(joint);
  const double side = is_right(joint) && range.axis > 0 ? -1.0 : 1.0;
  const auto value = [&](const Pose& pose) { return side * log(pose.rotations[at])[range.axis]; };
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
    Vec3 turn = log(pose.rotations[at]);
    turn[range.axis] = side * after;
    pose.rotations[at] = in_hemisphere_of(pose.rotations[at], exp(turn));
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
  for (const JointRange& range : joint_ranges) {
    limit_joint(result, original, range.left_joint, range);
    limit_joint(result, original, mirrored(range.left_joint), range);
  }
  return result;
}

}  // namespace mien::motion
