#pragma once

#include "motion/math/geometry.h"

namespace mien::motion {

/// The state of a critically damped spring: a value that approaches a goal with a continuous rate
/// of change.
struct DampedSpring {
  double value = 0.0;
  double rate = 0.0;  ///< of the value, per second
};

/// The spring `seconds` later, with angular frequency `stiffness` (1/s) and a constant goal: the
/// exact solution for any step.
DampedSpring spring_step(const DampedSpring& number, double goal, double stiffness, double seconds);

/// Root motion of a walker: its position and heading on the floor, and their rates. Steps are
/// planned relative to it. Speed and turning rate follow their goals with mean lags of 0.54 and
/// 0.43 s and continuous acceleration.
struct RootMotion {
  Vec3 place = Vec3::Zero();  ///< on the floor, metres
  double heading = 0.0;       ///< about +Y from +Z, radians
  DampedSpring speed;         ///< along the heading, m/s
  DampedSpring turning;       ///< radians/s
  DampedSpring wanted_speed;  ///< smoothed goal of the speed, m/s
  DampedSpring wanted_turning;
};

/// The root motion after a small time step of `seconds`, with these goals for speed (m/s) and
/// turning rate (radians/s).
RootMotion advanced(RootMotion root, double speed, double turning, double seconds);

/// Unit facing direction, and transforms between the root's frame (x to the left, y up, z forward)
/// and world space.
Vec3 forward_of(const RootMotion& root);
Vec3 to_world(const RootMotion& root, const Vec3& local);
Vec3 to_local(const RootMotion& root, const Vec3& world);

/// Remaining rotation (radians) and travel (metres) of the root if both goals are 0 from now on.
double coasting_turn(const RootMotion& root);
double coasting_distance(const RootMotion& root);

}  // namespace mien::motion
