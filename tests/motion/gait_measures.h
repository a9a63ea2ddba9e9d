#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "motion/math/rotation.h"
#include "motion/procedural/foot_roll.h"
#include "motion/skeleton/example.h"

namespace mien::motion::test {

/// The points of one foot that can touch the floor, at one frame. World, metres.
struct FootPoints {
  Vec3 heel;
  Vec3 ball;
  Vec3 tip;
};

inline FootPoints foot_points(const Clip& clip, size_t frame, bool left) {
  const BodyJoint ankle = left ? LeftAnkle : RightAnkle;
  const auto a = static_cast<size_t>(ankle);
  const FootShape shape = foot_shape(clip.body, ankle);
  const JointTransforms world = world_transforms(clip.body, clip.poses[frame]);
  return {world.positions[a] + world.rotations[a] * shape.heel, world.positions[a + 1],
          world.positions[a + 1] + world.rotations[a + 1] * Vec3(0, 0, shape.toe_length)};
}

/// Which parts of a foot bear on the floor at a frame: heel and ball at their lowest, within 0.1
/// mm.
struct FootContact {
  bool heel;
  bool ball;
};

inline FootContact foot_contact(const Clip& clip, size_t frame, bool left) {
  const FootPoints points = foot_points(clip, frame, left);
  const FootShape shape = foot_shape(clip.body, left ? LeftAnkle : RightAnkle);
  return {points.heel.y() < 1e-5, points.ball.y() < shape.ball_height + 1e-5};
}

/// Share of frames with this foot on the floor.
inline double stance_share(const Clip& clip, bool left) {
  int standing = 0;
  for (size_t i = 0; i < clip.poses.size(); ++i) {
    const FootContact contact = foot_contact(clip, i, left);
    standing += contact.heel || contact.ball;
  }
  return static_cast<double>(standing) / clip.frame_count();
}

/// Largest distance that heel or ball travels while it bears on the floor, frame to frame summed
/// over one contact.
inline double planted_travel(const Clip& clip, bool left) {
  double largest = 0.0;
  double heel = 0.0;
  double ball = 0.0;
  const size_t n = clip.poses.size();
  for (size_t i = 0; i + 1 < 2 * n; ++i) {
    const size_t from = i % n;
    const size_t to = (i + 1) % n;
    const Vec3 next_cycle = to == 0 ? clip.cycle_displacement : Vec3(Vec3::Zero());
    const FootContact a = foot_contact(clip, from, left);
    const FootContact b = foot_contact(clip, to, left);
    const FootPoints p = foot_points(clip, from, left);
    const FootPoints q = foot_points(clip, to, left);
    heel = a.heel && b.heel ? heel + (q.heel + next_cycle - p.heel).norm() : 0.0;
    ball = a.ball && b.ball ? ball + (q.ball + next_cycle - p.ball).norm() : 0.0;
    largest = std::max({largest, heel, ball});
  }
  return largest;
}

/// Lowest point of both feet over the clip, metres above the floor (toe joint and tip measured from
/// the underside of the toes).
inline double lowest_point(const Clip& clip) {
  double lowest = 1.0;
  for (size_t i = 0; i < clip.poses.size(); ++i) {
    for (const bool left : {true, false}) {
      const FootPoints points = foot_points(clip, i, left);
      const double sole = foot_shape(clip.body, left ? LeftAnkle : RightAnkle).ball_height;
      lowest = std::min({lowest, points.heel.y(), points.ball.y() - sole, points.tip.y() - sole});
    }
  }
  return lowest;
}

/// Angle between two bones that meet at a joint, degrees, 0 when straight.
inline double bend_deg(const std::vector<Vec3>& joints, BodyJoint upper, BodyJoint middle,
                       BodyJoint lower) {
  const Vec3 a = joints[static_cast<size_t>(middle)] - joints[static_cast<size_t>(upper)];
  const Vec3 b = joints[static_cast<size_t>(lower)] - joints[static_cast<size_t>(middle)];
  return std::acos(std::clamp(a.normalized().dot(b.normalized()), -1.0, 1.0)) / radians_per_degree;
}

inline std::vector<double> knee_flexion_deg(const Clip& clip, bool left) {
  std::vector<double> flexion;
  for (const Pose& pose : clip.poses) {
    const std::vector<Vec3> joints = world_positions(clip.body, pose);
    flexion.push_back(left ? bend_deg(joints, LeftHip, LeftKnee, LeftAnkle)
                           : bend_deg(joints, RightHip, RightKnee, RightAnkle));
  }
  return flexion;
}

/// Whole-body centre of mass with the male segment parameters of de Leva 1996.
inline Vec3 centre_of_mass(const Skeleton& body, const Pose& pose) {
  struct Segment {
    BodyJoint from;
    BodyJoint to;
    double mass;
    double centre;
  };
  constexpr std::array<Segment, 12> segments = {{{Neck, Head, 0.0694, 1.0},
                                                 {Neck, Pelvis, 0.4346, 0.5138},
                                                 {LeftShoulder, LeftElbow, 0.0271, 0.5772},
                                                 {RightShoulder, RightElbow, 0.0271, 0.5772},
                                                 {LeftElbow, LeftWrist, 0.0223, 0.65},
                                                 {RightElbow, RightWrist, 0.0223, 0.65},
                                                 {LeftHip, LeftKnee, 0.1416, 0.4095},
                                                 {RightHip, RightKnee, 0.1416, 0.4095},
                                                 {LeftKnee, LeftAnkle, 0.0433, 0.4395},
                                                 {RightKnee, RightAnkle, 0.0433, 0.4395},
                                                 {LeftAnkle, LeftToe, 0.0137, 0.5},
                                                 {RightAnkle, RightToe, 0.0137, 0.5}}};
  const std::vector<Vec3> joints = world_positions(body, pose);
  Vec3 sum = Vec3::Zero();
  double mass = 0.0;
  for (const Segment& s : segments) {
    const Vec3& from = joints[static_cast<size_t>(s.from)];
    sum += s.mass * (from + s.centre * (joints[static_cast<size_t>(s.to)] - from));
    mass += s.mass;
  }
  return sum / mass;
}

/// Amplitude of the n-th harmonic of a periodic series.
inline double harmonic_amplitude(const std::vector<double>& series, int n) {
  double c = 0.0;
  double s = 0.0;
  for (size_t i = 0; i < series.size(); ++i) {
    const double angle = 2.0 * pi * n * static_cast<double>(i) / static_cast<double>(series.size());
    c += series[i] * std::cos(angle);
    s += series[i] * std::sin(angle);
  }
  return 2.0 * std::hypot(c, s) / static_cast<double>(series.size());
}

inline double range_of(const std::vector<double>& series) {
  const auto [least, most] = std::minmax_element(series.begin(), series.end());
  return *most - *least;
}

}  // namespace mien::motion::test
