#pragma once

#include "motion/steered_walk/steered_moment.h"

namespace mien::motion {

/// Limits of turning: the turning rate, radians/s, and the lateral acceleration of a walk in a
/// curve, m/s².
inline constexpr double fastest_turning = 1.25;
inline constexpr double most_sideways_acceleration = 1.6;

/// Goals of the root motion: speed (m/s) and turning (radians/s).
struct RootGoal {
  double speed = 0.0;
  double turning = 0.0;
};

/// Angle to the requested heading, radians, that remains after the root's present turning has
/// decayed; 0 if no heading is requested.
double remaining_turn(const RootMotion& root, const Steering& steering);

/// The present goals of the root motion. `own` is the moods' speed at pace 1, m/s. Turning is
/// limited (`fastest_turning`, `most_sideways_acceleration`), and speed is reduced in sharp turns
/// to a requested heading.
RootGoal goal_of(const RootMotion& root, const Steering& steering, double own);

/// The predicted root motion under constant steering.
RootMotion predicted(RootMotion root, const Steering& steering, double own, double seconds);

/// Cycle frequency of a gait, 1/s.
double cycle_rate(const LegCycle& steady);

/// The next landing of a swinging leg: to the side of the predicted path of the root, without
/// crossing the other foot, and within reach of the leg.
Landing landing_of(const SteeredWalk& walker, const SteeredMoment& moment, std::size_t side,
                   const Steering& steering, double own);

/// Whether the current footprints form a stable stance with the root at rest (`rest`).
bool stands_well(const SteeredWalk& walker, const SteeredMoment& moment, const RootMotion& rest);

}  // namespace mien::motion
