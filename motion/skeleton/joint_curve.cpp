#include "motion/skeleton/joint_curve.h"

#include <algorithm>
#include <cmath>

namespace mien::motion {

Directions directions_of(const Quat& rotation) {
  const Mat3 m = rotation.toRotationMatrix();
  Directions directions;
  directions << m.col(0), m.col(1);
  return directions;
}

Quat to_rotation(const Directions& directions, const Quat& previous) {
  return to_rotation(DirectionVectors{directions.head<3>(), directions.tail<3>()}, previous);
}

std::vector<Directions> direction_curve(const Clip& clip, int joint) {
  std::vector<Directions> curve;
  curve.reserve(clip.poses.size());
  for (const Pose& pose : clip.poses) {
    curve.push_back(directions_of(pose.rotations[static_cast<size_t>(joint)]));
  }
  return curve;
}

void set_rotations(Clip& clip, int joint, const std::vector<Directions>& curve) {
  const auto at = static_cast<size_t>(joint);
  Quat previous = clip.poses.empty() ? Quat::Identity() : clip.poses.front().rotations[at];
  for (size_t f = 0; f < clip.poses.size(); ++f) {
    previous = to_rotation(curve[f], previous);
    clip.poses[f].rotations[at] = previous;
  }
}

Directions value_at(const std::vector<Directions>& curve, double frame, bool periodic) {
  const auto count = static_cast<long>(curve.size());
  const auto at = [&](long i) -> const Directions& {
    if (periodic) return curve[static_cast<size_t>(((i % count) + count) % count)];
    return curve[static_cast<size_t>(std::clamp(i, 0L, count - 1))];
  };
  if (!periodic) frame = std::clamp(frame, 0.0, static_cast<double>(count - 1));
  if (std::abs(frame - std::round(frame)) < 1e-9) return at(std::lround(frame));
  const auto whole = static_cast<long>(std::floor(frame));
  const double t = frame - std::floor(frame);
  const Directions &a = at(whole - 1), &b = at(whole), &c = at(whole + 1), &d = at(whole + 2);
  return 0.5 * (2.0 * b + t * ((c - a) + t * ((2.0 * a - 5.0 * b + 4.0 * c - d) +
                                              t * (3.0 * (b - c) + d - a))));
}

}  // namespace mien::motion
