#pragma once

#include "motion/math/geometry.h"

namespace mien::motion {

/// A number that follows another without a jump of its rate.
struct Followed {
  double value = 0.0;
  double rate = 0.0;  ///< 1/s
};

/// `seconds` later, as a critically damped spring of angular frequency `stiffness` (1/s) pulls it
/// to a goal that stays: exact, however long the step.
Followed followed(const Followed& number, double goal, double stiffness, double seconds);

/// Where a walker is on the floor, which way it faces, and how both go on: the frame in which its
/// steps are taken. Speed and turning follow what is wanted of them, late by a third of a second,
/// with an acceleration that does not jump.
struct Carriage {
  Vec3 place = Vec3::Zero();  ///< on the floor, metres
  double heading = 0.0;       ///< about +Y from +Z, radians
  Followed speed;             ///< along the heading, m/s
  Followed turning;           ///< radians/s
  Followed wanted_speed;      ///< what is wanted, smoothed
  Followed wanted_turning;
};

/// `seconds` (a small step) later.
Carriage advanced(Carriage carriage, double speed, double turning, double seconds);

/// Unit vector to where it faces, and what of the carriage's frame (x to the left, y up, z forward)
/// is where in the world, and the other way round.
Vec3 forward_of(const Carriage& carriage);
Vec3 to_world(const Carriage& carriage, const Vec3& local);
Vec3 to_local(const Carriage& carriage, const Vec3& world);

/// How much farther it turns (radians) and goes (metres) when nothing more is wanted from now on.
double coasting_turn(const Carriage& carriage);
double coasting_way(const Carriage& carriage);

}  // namespace mien::motion
