#include "motion/math/spring_damper.h"

#include <cmath>

namespace mien::motion {

SpringState after(const SpringState& state, const SpringDamper& spring, double target_speed,
                  double force, double seconds) {
  const double w = spring.frequency;
  const double z = spring.damping;
  // A steady state follows the target at this distance; what deviates from it oscillates or decays.
  const double steady = (force / w - 2.0 * z * target_speed) / w;
  const double x = state.offset - steady;
  const double v = state.speed - target_speed;
  const double rate = z * w;
  const double square = (z * z - 1.0) * w * w;
  // c and s are the even and the odd solution of the undamped or overdamped part.
  const double root = std::sqrt(std::abs(square));
  double c = 1.0, s = seconds;
  double decay = std::exp(-rate * seconds);
  if (root * seconds > 1e-6 && square < 0.0) {
    c = std::cos(root * seconds);
    s = std::sin(root * seconds) / root;
  } else if (root * seconds > 1e-6) {
    // cosh and sinh times the decay, which alone would overflow.
    const double slow = std::exp((root - rate) * seconds);
    const double fast = std::exp(-(root + rate) * seconds);
    c = 0.5 * (slow + fast);
    s = 0.5 * (slow - fast) / root;
    decay = 1.0;
  }
  const double offset = decay * (x * c + (v + rate * x) * s);
  const double speed = decay * (v * c - (rate * v + w * w * x) * s);
  return {offset + steady, speed + target_speed};
}

}  // namespace mien::motion
