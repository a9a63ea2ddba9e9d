#pragma once

#include <array>
#include <vector>

#include "motion/biomechanics/lint_motion.h"

namespace mien::motion {

inline constexpr double gravity = 9.81;  ///< m/s², downwards

/// Number of body segments with masses, in the order of `segment_masses` (body_mass.h).
inline constexpr int segment_count = 14;

/// The joint whose frame each segment follows.
extern const std::array<int, segment_count> segment_joints;

/// Dynamics of the body in one frame, in world space. Masses are fractions of the body mass.
struct BodyDynamics {
  JointTransforms world;                     ///< joint transforms of the low-pass filtered motion
  std::array<double, segment_count> mass{};  ///< fractions of the body mass
  std::array<Vec3, segment_count> centre;    ///< centres of mass of the segments, m
  std::array<Vec3, segment_count> acceleration;  ///< of the segments' centres of mass, m/s²
  /// Rate of change of each segment's angular momentum about its own centre of mass, per kg of
  /// body mass: m²/s².
  std::array<Vec3, segment_count> momentum_rate;

  Vec3 centre_of_mass = Vec3::Zero();  ///< m
  Vec3 velocity = Vec3::Zero();        ///< of the centre of mass, m/s
  /// Ground reaction force by inverse dynamics, N per kg of body mass (m/s²): the acceleration of
  /// the centre of mass minus the gravitational acceleration.
  Vec3 ground_reaction = Vec3::Zero();
  /// Zero-moment point: the point on the floor about which the ground reaction force has no
  /// horizontal moment (Vukobratović and Borovac 2004), m. It lies within the support polygon if
  /// only the floor supports the body. While the vertical force is less than a tenth of the body
  /// weight, it is undefined and set to the floor point below the centre of mass.
  Vec3 zero_moment_point = Vec3::Zero();
};

/// Dynamics of a motion of the canonical body, one entry per frame of its prepared clip. The root
/// positions and joint rotations are first low-pass filtered at `gait_cutoff_hz` (6 Hz at 30 frames
/// per second or more; Winter 2009). Segments are rotationally symmetric about their long axes,
/// with the radii of gyration of de Leva (1996).
std::vector<BodyDynamics> body_dynamics(const LintMotion& motion);

}  // namespace mien::motion
