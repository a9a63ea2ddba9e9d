#pragma once

#include <vector>

#include "motion/gait/foot_plant.h"
#include "motion/skeleton/clip.h"

namespace mien::motion {

/// How the root follows the planted feet.
enum class HipPath {
  exact,   ///< frame by frame: planted feet stand still, but the root may jerk (as in the emotion
           ///< thesis)
  smooth,  ///< low-pass filtered at 4 Hz; the remaining slide must be removed by foot locking
           ///< (foot_lock.h)
};

/// The clip with its root moved so that the feet planted in `original` stand still again after a
/// modification made them slide: the shift added to the root is h(t) = h(t−1) − Δp, where p is the
/// pivot of the planted foot (heel, then ball; the mean of both feet when both stand). During
/// flight the velocity correction is interpolated linearly from one plant to the next. The height
/// is corrected too, so that planted feet are as high as in the original.
///
/// The cycle displacement of a loop follows from its feet; drift sideways from its line of travel
/// (all drift if the original travels less than 5 cm per cycle) is removed evenly over the cycle.
/// Neither clip walks in place; both have the same number of frames and frame rate.
Clip with_hip_shift(const Clip& clip, const Clip& original, const std::vector<FootPlant>& plants,
                    HipPath path);

/// As above with a smooth path, but the root moves only by what the modification made the feet
/// slide: the slide of the same feet in `captured` is subtracted, so that a change of nothing
/// leaves the root's path and its speed as captured. `original` is `captured` with still feet.
Clip with_hip_shift_beyond(const Clip& captured, const Clip& clip, const Clip& original,
                           const std::vector<FootPlant>& plants);

}  // namespace mien::motion
