#pragma once

#include <array>

#include "motion/procedural/leg_cycle.h"
#include "motion/steered_walk/root_motion.h"

namespace mien::motion {

/// Coordinates of a foot in the root's frame, or the difference between two: ankle x, y, z
/// (metres), yaw, pitch and toe extension (radians).
using FootNumbers = Eigen::Matrix<double, 6, 1>;

/// State of one leg of a steered walker.
///
/// The foot stands on a fixed footprint or swings to the next one. The swing is that of a steady
/// straight walk (leg_cycle.h) plus a difference, which is interpolated from its value at toe off
/// to the value required by the next footprint. A steady walk thus agrees closely with that of the
/// parametric walker, and in starts, stops and turns the foot leaves and meets the floor without
/// sliding.
struct SteppingLeg {
  bool swinging = false;
  bool held = true;  ///< planted regardless of its phase, until the walk continues

  // While standing; world space.
  Vec3 print = Vec3::Zero();  ///< the footprint, as in `rolled_foot` (foot_roll.h)
  double yaw = 0.0;
  DampedSpring more_pitch;  ///< pitch in addition to that of the stance, radians; fades
  DampedSpring heel_rise;   ///< rise of the heel that lets the leg reach the floor, radians

  // While swinging.
  double toe_off = 0.0;                          ///< phase of the leg's own cycle at toe off
  double lands_at = 0.0;                         ///< cycle phase of the landing, unwrapped
  FootNumbers start = FootNumbers::Zero();       ///< difference from the steady walk at toe off …
  FootNumbers start_rate = FootNumbers::Zero();  ///< … and its rate, 1/s
  FootNumbers landing_rate = FootNumbers::Zero();  ///< rate of the difference at landing, 1/s
  std::array<DampedSpring, 3> landing;  ///< currently planned x, z and yaw of the foot at landing
};

/// The input of a leg at one time.
struct LegMoment {
  const LegCycle& steady;  ///< the leg's cycle of straight walking at the present gait and speed
  RootMotion root;
  double phase = 0.0;       ///< of the gait cycle, unwrapped
  double phase_rate = 0.0;  ///< 1/s
};

/// Phase of the leg's own cycle, from 0 (its heel strike) to less than 1.
double own_phase(const LegCycle& steady, double cycle_phase);

/// The foot's pose in the root's frame.
FootPose foot_of(const SteppingLeg& leg, const LegMoment& moment);

/// The foot's pose at the planned landing of a swinging leg, in the root's frame at that time.
FootPose landing_foot(const SteppingLeg& leg, const LegMoment& moment);

/// Completed share of a leg's swing, 0–1.
double swing_share(const SteppingLeg& leg, const LegMoment& moment);

/// Holds a standing leg in place; its heel is lowered.
void hold(SteppingLeg& leg, const LegMoment& moment);

/// Lets a held leg continue its stance.
void release(SteppingLeg& leg, const LegMoment& moment);

/// Starts the swing of a standing leg.
void lift_off(SteppingLeg& leg, const LegMoment& moment);

/// Planned landing of a swinging leg: the root at that time, and the footprint in its frame.
struct Landing {
  RootMotion root;
  Vec3 print = Vec3::Zero();
  double yaw = 0.0;
};

/// Adjusts the swing of the leg to a planned landing. `seconds` is the time since the last call,
/// infinite for the first call in a swing.
void plan_swing(SteppingLeg& leg, const LegMoment& moment, const Landing& landing, double seconds);

/// Advances a standing leg by `seconds`: deviations from the steady stance fade, and the heel rises
/// as far as the leg needs to reach the floor (`heel_rise`, radians).
void settle(SteppingLeg& leg, double heel_rise, double seconds);

/// Ends the swing: the foot is planted at its current position.
void touch_down(SteppingLeg& leg, const LegMoment& moment);

}  // namespace mien::motion
