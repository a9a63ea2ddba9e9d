#pragma once

#include "motion/dynamics/body_height.h"
#include "motion/math/spring_damper.h"
#include "motion/skeleton/clip.h"

namespace mien::motion {

/// Stiffness of the parts of the body. 1: they move as they do. Towards 0 they are slack: only the
/// share `stiffness` of a part's weight and inertia is carried by muscles, and a spring (below)
/// must hold the rest, so that the part sags, lags and swings on. Towards 2 they are held:
/// deviations from their mean posture shrink to nothing, without lag or overshoot.
struct Stiffness {
  double head = 1.0;
  double trunk = 1.0;
  double left_arm = 1.0;
  double right_arm = 1.0;
  double legs = 1.0;  ///< 0–1: slack legs yield to the load, and the body sinks

  friend bool operator==(const Stiffness&, const Stiffness&) = default;
};

/// Whether all parts move as they do.
bool is_unit(const Stiffness& stiffness);

/// The stiffness at a strength: distances from 1 are multiplied, within their ranges.
Stiffness scaled(const Stiffness& stiffness, double strength);

/// Natural frequencies (Hz) of the springs at a stiffness of ½, and of ordinary muscles under
/// additional weight. Chosen for this program: relaxed arms swing at 0.8 to 1.3 Hz, and trunk and
/// head begin to fall below about 0.25.
inline constexpr double arm_hz = 2.0;
inline constexpr double head_hz = 3.0;
inline constexpr double trunk_hz = 2.0;
inline constexpr double leg_hz = 3.0;

/// The spring of a part, after antagonistic control (Neff and Fiume 2002): two muscles pull a joint
/// to its target with a common stiffness. ω = 2π·hz·stiffness/(1 − stiffness), which is infinite at
/// 1; ζ = 0.3 + 0.7·stiffness, so that slack parts swing on. `stiffness` in [0, 1).
SpringDamper muscle_spring(double stiffness, double hz);

/// The clip with trunk, head and arms on springs and dampers, under gravity and carried along by
/// their joints. A deflection tilts spine and chest (half each), neck and head (half each) and
/// wrists in any direction but about their long axes, as do upper arms, and elbows about their
/// own axis, never beyond straight. `weight`: factor on gravity, 0–3, with which ordinary muscles
/// give way, too. Integrated in steps of at most 1/240 s, so that the result hardly depends on the
/// frame rate. A loop is repeated until it is periodic (to 1e-6 radians, at most 200 cycles); any
/// other clip begins at rest in balance with gravity. Legs and the root do not change.
Clip with_limb_dynamics(const Clip& clip, const Stiffness& stiffness, double weight);

/// The clip with its body on slack legs: its height follows that of the clip through the legs'
/// spring, under the force on the floor. Feet stay where they are; flights remain ballistic.
Clip with_slack_legs(const Clip& clip, double stiffness, double weight,
                     const std::vector<FootPlant>& plants, const std::vector<Airborne>& flights);

}  // namespace mien::motion
