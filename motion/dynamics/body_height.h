#pragma once

#include <vector>

#include "motion/gait/foot_plant.h"
#include "motion/skeleton/clip.h"

namespace mien::motion {

/// A stretch without contact: no foot touches the floor between two frames.
struct Airborne {
  int take_off = 0;  ///< last frame with contact
  int landing = 0;   ///< next frame with contact; of a loop, it may lie in the next cycle
};

/// Heights of the body's centre of mass (body_mass.h), metres, one per frame.
std::vector<double> body_heights(const Clip& clip);

/// The heights with every flight a parabola: from the height at take-off to that at landing, with
/// the acceleration of gravity. Speeds are continuous at both: on the floor, heights are changed
/// within 0.2 s of a flight.
std::vector<double> ballistic(std::vector<double> heights, const std::vector<Airborne>& flights,
                              double frames_per_second, bool loops);

/// Which feet stay where they are in the world when the body is raised or lowered.
enum class FeetStay {
  planted,  ///< feet on the floor; others go with the body
  all,      ///< swinging feet, too
};

/// The clip with the centre of mass raised or lowered to `heights` (metres, one per frame) by the
/// legs: feet stay where they are, other parts go with the pelvis. Where a leg would be stretched
/// beyond 0.985 of its length, and farther than it is, heights are lowered smoothly for half a
/// second around; where the pelvis would sink below 0.55 of the legs' length, they are raised.
/// Flights remain ballistic to rounding.
Clip with_body_heights(const Clip& clip, std::vector<double> heights,
                       const std::vector<FootPlant>& plants, const std::vector<Airborne>& flights,
                       FeetStay feet);

}  // namespace mien::motion
