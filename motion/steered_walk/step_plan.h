#pragma once

#include "motion/steered_walk/steered_moment.h"

namespace mien::motion {

/// Limits of turning: on the spot, radians/s, and of a walk in a curve, m/s².
inline constexpr double fastest_turning = 1.25;
inline constexpr double most_sideways_acceleration = 1.6;

/// Goals of the root motion: speed (m/s) and turning (radians/s).
struct RootGoal {
  double speed = 0.0;
  double turning = 0.0;
};

/// Remaining angle to the requested heading, radians, after its present turning has decayed; 0 if
/// no heading is requested.
double remaining_turn(const RootMotion& root, const Steering& steering);

/// The present goals of the root motion. `own` is the moods' speed at pace 1, m/s. Turning is
/// limited by the lateral acceleration of people in curves, and sharp turns are walked slowly.
RootGoal goal_of(const RootMotion& root, const Steering& steering, double own);

/// The predicted root motion under constant steering.
RootMotion predicted(RootMotion root, const Steering& steering, double own, double seconds);

/// Cadence of a gait in cycles a second.
double cycle_rate(const LegCycle& steady);

/// The next landing of a swinging leg: beside the predicted path of the root, without crossing the
/// other foot.
Landing landing_of(const SteeredWalk& walker, const SteeredMoment& moment, std::size_t side,
                   const Steering& steering, double own);

/// Whether the present footprints are a stable stance once the root has come to rest.
bool stands_well(const SteeredWalk& walker, const SteeredMoment& moment, const RootMotion& rest);

}  // namespace mien::motion
