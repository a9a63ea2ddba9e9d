#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "motion/gait/gait_events.h"

namespace mien::motion {

/// The seven events of a stride, from a heel strike of one foot to its next, in fractional frames:
/// heel strike, toe off of the other foot, passing of the other ankle, strike of the other foot,
/// own toe off, passing of the own ankle, next heel strike. In running, each toe off occurs before
/// the heel strike that precedes it in this list.
struct Stride {
  bool left = true;  ///< the foot that strikes first
  double strike = 0.0;
  double other_toe_off = 0.0;
  double other_passes = 0.0;
  double other_strike = 0.0;
  double toe_off = 0.0;
  double passes = 0.0;
  double next_strike = 0.0;
  bool confirmed = true;  ///< all heel strikes and toe offs agree with foot contacts

  double period() const { return next_strike - strike; }
};

/// All strides of one foot in order of time. An interval between two strikes of the foot is omitted
/// unless the other foot strikes exactly once in it and all other events are found.
std::vector<Stride> strides(std::span<const GaitEvent> events, const FootProgress& progress,
                            bool left);

/// The 7 keytimes (gait.h), in frames after the left heel strike, from 0 to the period and at least
/// one frame apart. Empty if the period is too short for that.
std::optional<std::array<double, 7>> left_based_keyframes(const Stride& stride);

/// The frame of the stride's left heel strike.
inline double left_strike(const Stride& stride) {
  return stride.left ? stride.strike : stride.other_strike;
}

/// Whether both feet are off the floor between a toe off and the next strike.
bool has_flight(const Stride& stride);

}  // namespace mien::motion
