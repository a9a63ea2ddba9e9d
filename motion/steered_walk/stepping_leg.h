#pragma once

#include <array>

#include "motion/procedural/leg_cycle.h"
#include "motion/steered_walk/carriage.h"

namespace mien::motion {

/// A foot in the carriage's frame, or the difference of two: ankle x, y, z (metres), yaw, pitch and
/// extension of the toes (radians).
using FootNumbers = Eigen::Matrix<double, 6, 1>;

/// One leg of a walker that goes where it is steered.
///
/// It stands on a print that does not move, or swings to the next one. The swing is that of a
/// steady walk straight on (leg_cycle.h) plus a difference, which goes from what the foot's last
/// moments on the floor differed to what the next print asks for: so steady walks are those of the
/// walker, and starts, stops and turns leave and meet the floor at rest.
struct SteppingLeg {
  bool swinging = false;
  bool held = true;  ///< stands on, whatever its phase: waits for the walk to go on

  // While it stands. World space.
  Vec3 print = Vec3::Zero();  ///< as `rolled_foot` (foot_roll.h) means it
  double yaw = 0.0;
  Followed more_pitch;  ///< over that of the stance, radians; fades
  Followed heel_rise;   ///< that the leg asks for to reach, radians

  // While it swings.
  double toe_off = 0.0;                          ///< own phase at which it left the floor
  double lands_at = 0.0;                         ///< cycle phase, unwrapped
  FootNumbers start = FootNumbers::Zero();       ///< difference from the steady walk at toe off …
  FootNumbers start_rate = FootNumbers::Zero();  ///< … and its rate, 1/s
  FootNumbers landing_rate = FootNumbers::Zero();  ///< of the difference as it lands, 1/s
  std::array<Followed, 3> landing;  ///< x, z and yaw of the foot as it lands, as planned now
};

/// What of a walk a leg needs to know, at one moment.
struct LegMoment {
  const LegCycle& steady;  ///< straight on, at the gait and speed of the moment
  Carriage carriage;
  double phase = 0.0;       ///< of the cycle, unwrapped
  double phase_rate = 0.0;  ///< 1/s
};

/// Phase of the leg's own cycle, 0 ≤ own < 1; 0 is its heel strike.
double own_phase(const LegCycle& steady, double cycle_phase);

/// The foot in the carriage's frame.
FootPose foot_of(const SteppingLeg& leg, const LegMoment& moment);

/// The foot of a swinging leg at the moment of its landing, as it is planned now, in the frame of
/// the carriage then.
FootPose landing_foot(const SteppingLeg& leg, const LegMoment& moment);

/// Share of its swing that a swinging leg has behind it.
double swing_share(const SteppingLeg& leg, const LegMoment& moment);

/// Holds the standing leg where it is, its heel sinking.
void hold(SteppingLeg& leg, const LegMoment& moment);

/// Lets the held leg go on with its stance.
void release(SteppingLeg& leg, const LegMoment& moment);

/// The standing leg leaves the floor.
void lift_off(SteppingLeg& leg, const LegMoment& moment);

/// Where a swinging leg will come down: the carriage then, and the print in the carriage's frame.
struct Landing {
  Carriage carriage;
  Vec3 print = Vec3::Zero();
  double yaw = 0.0;
};

/// Turns the swing of the leg towards a landing; `seconds` since this was last done, infinite the
/// first time.
void aim(SteppingLeg& leg, const LegMoment& moment, const Landing& landing, double seconds);

/// A standing leg `seconds` later: what was left of another stance fades, and the heel goes where
/// the leg asks for it to reach the floor (`heel_rise`, radians).
void settle(SteppingLeg& leg, double heel_rise, double seconds);

/// The swinging leg comes down where it is.
void touch_down(SteppingLeg& leg, const LegMoment& moment);

}  // namespace mien::motion
