#pragma once

#include <vector>

#include "motion/gait/foot_plant.h"
#include "motion/skeleton/clip.h"

namespace mien::motion {

struct FootLockOptions {
  double blend_seconds = 0.17;   ///< over which corrections fade in and out (Kovar 2002)
  double flat_metres = 0.006;    ///< flat sole: heel and ball are this near their lowest positions
  double lifted_metres = 0.015;  ///< a heel or ball this much higher has left the floor
  double extension = 0.98;       ///< maximum leg extension by corrections, fraction of leg length
  bool keep_velocity = false;    ///< the velocity of a foot stays continuous at the ends of a plant
};

/// Removes foot skate. During a plant, the foot rotates about its heel until the sole is flat,
/// stands still, and rotates about its ball until it leaves the floor.
///
/// The flat sole is placed on the floor (y = 0). First the whole figure is shifted vertically by
/// the mean height error of both feet; then each foot is shifted by the remaining error, because in
/// captures one foot is often higher than the other. Toes that are raised while the heel stands are
/// lowered. Corrections fade out during the swing. The pelvis is lowered smoothly where a leg would
/// have to stretch, and knees bent backwards are bent forwards (after Kovar, Schreiner and Gleicher
/// 2002; foot_placement.h). The clip must not walk in place.
Clip foot_locked(const Clip& clip, const std::vector<FootPlant>& plants,
                 const FootLockOptions& options = {});

/// Maximum horizontal displacement, metres, of the supporting part of a foot during a plant: of the
/// heel from its contact to flat foot, of the ball from flat foot until it lifts. Maximum over all
/// plants.
double planted_drift(const Clip& clip, const std::vector<FootPlant>& plants,
                     const FootLockOptions& options = {});

}  // namespace mien::motion
