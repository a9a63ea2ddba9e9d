#pragma once

#include <vector>

#include "motion/gait/foot_plant.h"
#include "motion/skeleton/clip.h"

namespace mien::motion {

/// How the root follows the planted feet.
enum class HipPath {
  exact,   ///< frame by frame: planted feet stand still, jerks and all (the thesis)
  smooth,  ///< what is slower than 4 Hz; what is left over has to be locked (foot_lock.h)
};

/// The clip with its root moved so that feet which stood in `original` stand again, after changes
/// that made them slide: h(t) = h(t−1) − Δp, p being the planted foot's pivot (heel, then ball; the
/// mean of both feet when both stand). Over flights the change of velocity goes evenly from one
/// plant to the next. The lowest foot is as high as it was in the original.
///
/// A loop walks as far in a cycle as its feet then carry it; what would drive it off its line is
/// spread over the cycle. Both clips travel and have the same frames.
Clip with_hip_shift(const Clip& clip, const Clip& original, const std::vector<FootPlant>& plants,
                    HipPath path);

}  // namespace mien::motion
