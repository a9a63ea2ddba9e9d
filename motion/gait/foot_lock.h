#pragma once

#include <vector>

#include "motion/gait/foot_plant.h"
#include "motion/skeleton/clip.h"

namespace mien::motion {

struct FootLockOptions {
  double blend_seconds = 0.17;  ///< a foot's correction fades in and out over this (Kovar 2002)
  double flat_metres = 0.006;   ///< the sole is flat while heel and ball are this near their lowest
  double lifted_metres = 0.015;  ///< a heel or ball this much higher has left the floor
  double extension = 0.98;       ///< largest extension by a correction, share of the leg's length
  bool keep_velocity = false;    ///< corrections leave a plant with continuous velocity
};

/// Removes foot skate: while planted, a foot turns about its heel until the sole is flat, stands
/// still, and turns about its ball until it leaves the floor. The flat sole comes to stand on the
/// floor (y = 0): first the whole figure is moved up or down by what both feet hang above it on the
/// average, then each foot by the rest, for captures often have one higher than the other;
/// toes that hang above a standing heel come down too.
/// Corrections fade over the swing; the
/// pelvis sinks, smoothly, where a leg would have to stretch; knees stay in their plane and bones
/// keep their lengths (after Kovar, Schreiner and Gleicher 2002). The clip must travel, not walk in
/// place.
Clip foot_locked(const Clip& clip, const std::vector<FootPlant>& plants,
                 const FootLockOptions& options = {});

/// Horizontal distance, metres, that the part of a foot that stands on the floor moves during a
/// plant: the ball from flat sole until it lifts, the heel from when it comes down to flat sole.
/// Largest over all plants.
double planted_drift(const Clip& clip, const std::vector<FootPlant>& plants,
                     const FootLockOptions& options = {});

}  // namespace mien::motion
