#include "motion/measures/motion_measures.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mien::motion {

namespace {

/// Extremes of a set of points.
struct Extent {
  Vec3 least = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 most = Vec3::Constant(-std::numeric_limits<double>::infinity());

  void add(const Vec3& point) {
    least = least.cwiseMin(point);
    most = most.cwiseMax(point);
  }
  Vec3 size() const { return most - least; }
};

double forward_tilt(const Vec3& segment) { return std::atan2(segment.z(), segment.y()); }

/// Direction of a sideways line about the vertical.
double turn(const Vec3& line) { return std::atan2(line.z(), line.x()); }

double bend(const Vec3& upper, const Vec3& lower) {
  return std::atan2(upper.cross(lower).norm(), upper.dot(lower));
}

}  // namespace

std::array<double, motion_measure_count> values_of(const MotionMeasures& m) {
  return {m.speed_m_s,      m.tempo_hz,       m.travel_m,          m.hand_range_m,
          m.hand_speed_m_s, m.hand_spread_m,  m.elbow_flexion_rad, m.trunk_lean_rad,
          m.head_pitch_rad, m.trunk_turn_rad, m.least_knee_rad,    m.bounce_m,
          m.sway_m,         m.lift_share,     m.asymmetry_m};
}

const std::array<std::string_view, motion_measure_count>& motion_measure_names() {
  static constexpr std::array<std::string_view, motion_measure_count> names = {
      "speed_m_s",      "tempo_hz",          "travel_m",       "hand_range_m",   "hand_speed_m_s",
      "hand_spread_m",  "elbow_flexion_rad", "trunk_lean_rad", "head_pitch_rad", "trunk_turn_rad",
      "least_knee_rad", "bounce_m",          "sway_m",         "lift_share",     "asymmetry_m"};
  return names;
}

MotionMeasures measure(const Example& example) {
  const Clip& clip = example.clip;
  const double duration = std::max(clip.duration_seconds(), 1e-9);
  const auto paths = joint_paths(clip);
  const auto count = static_cast<double>(paths.size());

  MotionMeasures m;
  const Vec3 last =
      clip.loops ? Vec3(paths.front()[Pelvis] + clip.cycle_displacement) : paths.back()[Pelvis];
  const Vec3 travel = last - paths.front()[Pelvis];
  m.travel_m = std::hypot(travel.x(), travel.z());
  m.speed_m_s = m.travel_m / duration;
  m.tempo_hz = 1.0 / duration;

  Extent left_hand, right_hand, pelvis, left_ankle, right_ankle;
  double least_turn = std::numeric_limits<double>::infinity();
  double most_turn = -least_turn;
  double left_knee = least_turn;
  double right_knee = least_turn;
  for (size_t f = 0; f < paths.size(); ++f) {
    const auto& at = paths[f];
    const Vec3& origin = at[Pelvis];
    left_hand.add(at[LeftWrist] - origin);
    right_hand.add(at[RightWrist] - origin);
    left_ankle.add(at[LeftAnkle] - origin);
    right_ankle.add(at[RightAnkle] - origin);
    // The way along +Z is travel, not bounce or sway.
    pelvis.add(origin);
    m.hand_spread_m += (at[LeftWrist] - at[RightWrist]).norm() / count;
    m.elbow_flexion_rad +=
        0.5 / count *
        (bend(at[LeftElbow] - at[LeftShoulder], at[LeftWrist] - at[LeftElbow]) +
         bend(at[RightElbow] - at[RightShoulder], at[RightWrist] - at[RightElbow]));
    m.trunk_lean_rad += forward_tilt(at[Neck] - origin) / count;
    m.head_pitch_rad += forward_tilt(at[Head] - at[Neck]) / count;
    const double shoulders = turn(at[LeftShoulder] - at[RightShoulder]);
    least_turn = std::min(least_turn, shoulders);
    most_turn = std::max(most_turn, shoulders);
    left_knee = std::min(left_knee, bend(at[LeftKnee] - at[LeftHip], at[LeftAnkle] - at[LeftKnee]));
    right_knee =
        std::min(right_knee, bend(at[RightKnee] - at[RightHip], at[RightAnkle] - at[RightKnee]));
    if (f == 0) continue;
    const auto& before = paths[f - 1];
    for (const BodyJoint wrist : {LeftWrist, RightWrist}) {
      const Vec3 step = (at[wrist] - origin) - (before[wrist] - before[Pelvis]);
      m.hand_speed_m_s += 0.5 * step.norm() * clip.frames_per_second / std::max(count - 1.0, 1.0);
    }
  }
  m.hand_range_m = 0.5 * (left_hand.size().norm() + right_hand.size().norm());
  m.trunk_turn_rad = most_turn - least_turn;
  m.least_knee_rad = 0.5 * (left_knee + right_knee);
  m.bounce_m = pelvis.size().y();
  m.sway_m = pelvis.size().x();
  const double rise_and_sway = m.bounce_m + m.sway_m;
  m.lift_share = rise_and_sway > 0.0 ? m.bounce_m / rise_and_sway : 0.5;
  m.asymmetry_m = (left_ankle.size() - right_ankle.size()).norm();
  return m;
}

}  // namespace mien::motion
