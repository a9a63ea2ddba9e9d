#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "motion/gait/gait_events.h"

namespace mien::motion {

/// The seven events of a stride from one foot's heel strike to its next, in frames: strike,
/// the other foot's toe off, the other ankle passing, the other foot's strike, own toe off, own
/// ankle passing, next strike. In running the toe offs lie before the strikes they follow here.
struct Stride {
  bool left = true;  ///< the foot that strikes first
  double strike = 0.0;
  double other_toe_off = 0.0;
  double other_passes = 0.0;
  double other_strike = 0.0;
  double toe_off = 0.0;
  double passes = 0.0;
  double next_strike = 0.0;
  bool confirmed = true;  ///< all of its events agree with foot contacts

  double period() const { return next_strike - strike; }
};

/// All strides of one foot, by time; stretches between two strikes that hold no single step of the
/// other foot are left out.
std::vector<Stride> strides(std::span<const GaitEvent> events, const FootProgress& progress,
                            bool left);

/// Keytimes in frames after the left heel strike, ascending by at least one frame: 0 … period.
/// Empty when the period is too short for that.
std::optional<std::array<double, 7>> left_based_keyframes(const Stride& stride);

/// The frame of the stride's left heel strike.
inline double left_strike(const Stride& stride) {
  return stride.left ? stride.strike : stride.other_strike;
}

/// Whether both feet are off the floor between a toe off and the next strike.
bool has_flight(const Stride& stride);

}  // namespace mien::motion
