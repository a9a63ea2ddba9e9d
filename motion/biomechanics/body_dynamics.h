#pragma once

#include <array>
#include <vector>

#include "motion/biomechanics/subject.h"

namespace mien::motion {

inline constexpr double gravity = 9.81;  ///< m/s², downwards

/// Number of body segments with masses, in the order of `segment_masses` (body_mass.h).
inline constexpr int segment_count = 14;

/// The joint whose frame each segment follows.
extern const std::array<int, segment_count> segment_joints;

/// Dynamics of the body in one frame, world space. Masses are shares of the body's mass.
struct BodyDynamics {
  JointTransforms world;  ///< of the low-pass filtered motion
  std::array<double, segment_count> mass{};
  std::array<Vec3, segment_count> centre;        ///< m
  std::array<Vec3, segment_count> acceleration;  ///< m/s²
  std::array<Vec3, segment_count>
      momentum_rate;  ///< of rotation about the centre, m²/s² per kg of body

  Vec3 centre_of_mass = Vec3::Zero();  ///< m
  Vec3 velocity = Vec3::Zero();        ///< of the centre of mass, m/s
  /// Ground reaction force by inverse dynamics: the acceleration of the centre of mass minus
  /// gravity, newtons per kg of body mass.
  Vec3 ground_reaction = Vec3::Zero();
  /// Zero-moment point: the point of the floor about which this force has no horizontal moment
  /// (Vukobratović and Borovac 2004); within the soles of a body without other support.
  /// Meaningless, and set to the centre of mass, while the vertical force is less than a tenth of
  /// the body's weight.
  Vec3 zero_moment_point = Vec3::Zero();
};

/// Dynamics of a subject of the canonical body, frame by frame, after a 6 Hz low-pass of its root
/// and rotations (`gait_cutoff_hz`; Winter 2009). Segments rotate as cylinders with the radii of
/// gyration of de Leva 1996.
std::vector<BodyDynamics> body_dynamics(const LintSubject& subject);

}  // namespace mien::motion
