#pragma once

#include <array>
#include <vector>

#include "motion/biomechanics/subject.h"

namespace mien::motion {

inline constexpr double gravity = 9.81;  ///< m/s², downwards

/// The segments whose masses are told apart, in the order of `segment_masses` (body_mass.h).
inline constexpr int segment_count = 14;

/// Joint whose frame each of these segments turns with.
extern const std::array<int, segment_count> segment_joints;

/// One moment of a body in motion, world space. Masses are shares of the body's.
struct MovingBody {
  JointTransforms world;  ///< of the motion without marker noise
  std::array<double, segment_count> mass{};
  std::array<Vec3, segment_count> centre;        ///< m
  std::array<Vec3, segment_count> acceleration;  ///< m/s²
  std::array<Vec3, segment_count>
      momentum_rate;  ///< of rotation about the centre, m²/s² a kg of body

  Vec3 centre_of_mass = Vec3::Zero();  ///< m
  Vec3 velocity = Vec3::Zero();        ///< of the centre of mass, m/s
  /// What the floor does to the body by the laws of motion: its acceleration less that of gravity,
  /// newtons a kilogram of body.
  Vec3 floor_force = Vec3::Zero();
  /// Point of the floor about which this force needs no moment but a vertical one (Vukobratović and
  /// Borovac 2004): within the soles of a body that nothing else holds. Meaningless, and at the
  /// centre of mass, while the body presses with less than a tenth of its weight.
  Vec3 zero_moment_point = Vec3::Zero();
};

/// The motion of masses of a subject of the canonical body, frame by frame, after a 6 Hz low-pass
/// of its root and rotations (`gait_cutoff_hz`; Winter 2009). Segments turn like cylinders with the
/// radii of gyration of de Leva 1996.
std::vector<MovingBody> moving_body(const LintSubject& subject);

}  // namespace mien::motion
