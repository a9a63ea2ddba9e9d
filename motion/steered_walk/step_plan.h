#pragma once

#include "motion/steered_walk/steered_moment.h"

namespace mien::motion {

/// Limits of turning: on the spot, radians/s, and of a walk in a curve, m/s².
inline constexpr double fastest_turning = 1.25;
inline constexpr double most_sideways_acceleration = 1.6;

/// Speed (m/s) and turning (radians/s) that the carriage is to follow.
struct CarriageGoal {
  double speed = 0.0;
  double turning = 0.0;
};

/// What the walker still has to turn, radians, when it lets its turning run out; 0 when no heading
/// is asked for.
double heading_left(const Carriage& carriage, const Steering& steering);

/// What the steering asks of the carriage now. `own` is the moods' speed at pace 1, m/s. Turning is
/// limited by the sideways acceleration that people take in curves, and sharp turns are walked
/// slowly.
CarriageGoal goal_of(const Carriage& carriage, const Steering& steering, double own);

/// Where the carriage will be if the steering stays.
Carriage predicted(Carriage carriage, const Steering& steering, double own, double seconds);

/// Gait cycles a second of a gait.
double cycle_rate(const LegCycle& steady);

/// The next landing of a swinging leg: beside where the carriage will pass, not across the other
/// foot.
Landing landing_of(const SteeredWalk& walker, const SteeredMoment& moment, std::size_t side,
                   const Steering& steering, double own);

/// Whether the prints are good enough to stand on, once the carriage has come to rest.
bool stands_well(const SteeredWalk& walker, const SteeredMoment& moment, const Carriage& rest);

}  // namespace mien::motion
