#pragma once

namespace mien::motion {

/// A mass on a spring and a damper: x'' = −ω²·(x − target) − 2ζω·x' + force.
struct SpringDamper {
  double frequency = 1.0;  ///< ω, radians per second, > 0
  double damping =
      1.0;  ///< ζ: below 1 it overshoots, at 1 it returns fastest without, above slower
};

/// Distance from the target, and the speed of the mass itself.
struct SpringState {
  double offset = 0.0;
  double speed = 0.0;  ///< per second
};

/// The state `seconds` later: the exact solution, for any step, while the target moves at the
/// constant speed `target_speed` and the constant `force` (per unit of mass) acts.
SpringState after(const SpringState& state, const SpringDamper& spring, double target_speed,
                  double force, double seconds);

}  // namespace mien::motion
