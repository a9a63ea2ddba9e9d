#include "motion/measures/features/motion_measures.h"

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

/// World positions of all joints, a row a frame.
using JointPaths = std::vector<std::vector<Vec3>>;

/// Extent of a joint's path relative to the pelvis.
Extent extent(const JointPaths& paths, BodyJoint joint) {
  Extent result;
  for (const auto& at : paths) result.add(at[joint] - at[Pelvis]);
  return result;
}

void add_travel(MotionMeasures& m, const Clip& clip, const JointPaths& paths) {
  const double duration = std::max(clip.duration_seconds(), 1e-9);
  const Vec3 last =
      clip.loops ? Vec3(paths.front()[Pelvis] + clip.cycle_displacement) : paths.back()[Pelvis];
  const Vec3 travel = last - paths.front()[Pelvis];
  m.travel_m = std::hypot(travel.x(), travel.z());
  m.speed_m_s = m.travel_m / duration;
  m.tempo_hz = 1.0 / duration;
  Extent pelvis;  // the way along +Z is travel, not bounce or sway
  for (const auto& at : paths) pelvis.add(at[Pelvis]);
  m.bounce_m = pelvis.size().y();
  m.sway_m = pelvis.size().x();
  const double rise_and_sway = m.bounce_m + m.sway_m;
  m.lift_share = rise_and_sway > 0.0 ? m.bounce_m / rise_and_sway : 0.5;
}

void add_hands(MotionMeasures& m, double frames_per_second, const JointPaths& paths) {
  const auto count = static_cast<double>(paths.size());
  for (size_t f = 0; f < paths.size(); ++f) {
    const auto& at = paths[f];
    m.hand_spread_m += (at[LeftWrist] - at[RightWrist]).norm() / count;
    m.elbow_flexion_rad +=
        0.5 / count *
        (bend(at[LeftElbow] - at[LeftShoulder], at[LeftWrist] - at[LeftElbow]) +
         bend(at[RightElbow] - at[RightShoulder], at[RightWrist] - at[RightElbow]));
    if (f == 0) continue;
    const auto& before = paths[f - 1];
    for (const BodyJoint wrist : {LeftWrist, RightWrist}) {
      const Vec3 step = (at[wrist] - at[Pelvis]) - (before[wrist] - before[Pelvis]);
      m.hand_speed_m_s += 0.5 * step.norm() * frames_per_second / std::max(count - 1.0, 1.0);
    }
  }
  m.hand_range_m =
      0.5 * (extent(paths, LeftWrist).size().norm() + extent(paths, RightWrist).size().norm());
}

void add_trunk(MotionMeasures& m, const JointPaths& paths) {
  const auto count = static_cast<double>(paths.size());
  double least_turn = std::numeric_limits<double>::infinity();
  double most_turn = -least_turn;
  for (const auto& at : paths) {
    m.trunk_lean_rad += forward_tilt(at[Neck] - at[Pelvis]) / count;
    m.head_pitch_rad += forward_tilt(at[Head] - at[Neck]) / count;
    const double shoulders = turn(at[LeftShoulder] - at[RightShoulder]);
    least_turn = std::min(least_turn, shoulders);
    most_turn = std::max(most_turn, shoulders);
  }
  m.trunk_turn_rad = most_turn - least_turn;
}

/// Least flexion of the knee below a hip.
double least_knee(const JointPaths& paths, BodyJoint hip) {
  const auto knee = BodyJoint(hip + 1);
  const auto ankle = BodyJoint(hip + 2);
  double least = std::numeric_limits<double>::infinity();
  for (const auto& at : paths) {
    least = std::min(least, bend(at[knee] - at[hip], at[ankle] - at[knee]));
  }
  return least;
}

}  // namespace

std::array<double, motion_measure_count> values_of(const MotionMeasures& m) {
  return {m.speed_m_s,      m.tempo_hz,       m.travel_m,          m.hand_range_m,
          m.hand_speed_m_s, m.hand_spread_m,  m.elbow_flexion_rad, m.trunk_lean_rad,
          m.head_pitch_rad, m.trunk_turn_rad, m.least_knee_rad,    m.bounce_m,
          m.sway_m,         m.lift_share,     m.asymmetry_m};
}

MotionMeasures measure(const Example& example) {
  const JointPaths paths = joint_paths(example.clip);
  MotionMeasures m;
  add_travel(m, example.clip, paths);
  add_hands(m, example.clip.frames_per_second, paths);
  add_trunk(m, paths);
  m.least_knee_rad = 0.5 * (least_knee(paths, LeftHip) + least_knee(paths, RightHip));
  m.asymmetry_m = (extent(paths, LeftAnkle).size() - extent(paths, RightAnkle).size()).norm();
  return m;
}

}  // namespace mien::motion
