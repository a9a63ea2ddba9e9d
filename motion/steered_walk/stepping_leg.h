#pragma once

#include <array>

#include "motion/procedural/leg_cycle.h"
#include "motion/steered_walk/root_motion.h"

namespace mien::motion {

/// Coordinates of a foot in the root's frame, or the difference of two: ankle x, y, z (metres),
/// yaw, pitch and extension of the toes (radians).
using FootNumbers = Eigen::Matrix<double, 6, 1>;

/// State of one leg of a steered walker.
///
/// It stands on a print that does not move, or swings to the next one. The swing is that of a
/// steady walk straight on (leg_cycle.h) plus a difference, which goes from what the foot's last
/// moments on the floor differed to what the next print asks for: so steady walks are those of the
/// walker, and starts, stops and turns leave and meet the floor at rest.
struct SteppingLeg {
  bool swinging = false;
  bool held = true;  ///< stays planted whatever its phase, until the walk continues

  // While it stands. World space.
  Vec3 print = Vec3::Zero();  ///< as `rolled_foot` (foot_roll.h) means it
  double yaw = 0.0;
  DampedSpring more_pitch;  ///< over that of the stance, radians; fades
  DampedSpring heel_rise;   ///< needed for the leg to reach, radians

  // While it swings.
  double toe_off = 0.0;                          ///< own phase at which it left the floor
  double lands_at = 0.0;                         ///< cycle phase, unwrapped
  FootNumbers start = FootNumbers::Zero();       ///< difference from the steady walk at toe off …
  FootNumbers start_rate = FootNumbers::Zero();  ///< … and its rate, 1/s
  FootNumbers landing_rate = FootNumbers::Zero();  ///< of the difference as it lands, 1/s
  std::array<DampedSpring, 3> landing;  ///< x, z and yaw of the foot as it lands, as planned now
};

/// The input of a leg at one time.
struct LegMoment {
  const LegCycle& steady;  ///< straight on, at the gait and speed of the moment
  RootMotion root;
  double phase = 0.0;       ///< of the cycle, unwrapped
  double phase_rate = 0.0;  ///< 1/s
};

/// Phase of the leg's own cycle, 0 ≤ own < 1; 0 is its heel strike.
double own_phase(const LegCycle& steady, double cycle_phase);

/// The foot in the root's frame.
FootPose foot_of(const SteppingLeg& leg, const LegMoment& moment);

/// The foot of a swinging leg at its planned landing, in the root's frame at that time.
FootPose landing_foot(const SteppingLeg& leg, const LegMoment& moment);

/// Completed share of a leg's swing.
double swing_share(const SteppingLeg& leg, const LegMoment& moment);

/// Holds the standing leg where it is, its heel sinking.
void hold(SteppingLeg& leg, const LegMoment& moment);

/// Lets the held leg go on with its stance.
void release(SteppingLeg& leg, const LegMoment& moment);

/// The standing leg leaves the floor.
void lift_off(SteppingLeg& leg, const LegMoment& moment);

/// Planned landing of a swinging leg: the root at that time, and the footprint in its frame.
struct Landing {
  RootMotion root;
  Vec3 print = Vec3::Zero();
  double yaw = 0.0;
};

/// Adjusts the swing of the leg to a planned landing; `seconds` since the last call, infinite the
/// first time.
void plan_swing(SteppingLeg& leg, const LegMoment& moment, const Landing& landing, double seconds);

/// Advances a standing leg by `seconds`: deviations from the steady stance fade, and the heel rises
/// as far as the leg needs to reach the floor (`heel_rise`, radians).
void settle(SteppingLeg& leg, double heel_rise, double seconds);

/// The swinging leg comes down where it is.
void touch_down(SteppingLeg& leg, const LegMoment& moment);

}  // namespace mien::motion
