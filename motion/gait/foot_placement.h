#pragma once

#include <array>
#include <vector>

#include "motion/gait/foot_lock.h"

namespace mien::motion {

/// Place of a foot at one frame, world space.
struct FootPlace {
  Vec3 ankle;
  Quat rotation;
};

/// Where a foot is to be in each frame of a stretch. In a looping clip the stretch may run over the
/// end; its places then go on into the next cycle.
struct PlacedStretch {
  bool left = true;
  int first = 0;  ///< frame of places.front()
  std::vector<FootPlace> places;
};

/// Puts the feet to given places by bending the legs. What had to be added at the ends of a stretch
/// fades over `blend_seconds`; the pelvis sinks, smoothly, where a leg would have to stretch; knees
/// stay in their plane and bones keep their lengths (after Kovar, Schreiner and Gleicher 2002).
/// `lowered` is taken off the height of the left and right foot in all frames, within the stretches
/// too.
Clip with_feet_placed(const Clip& clip, const std::vector<PlacedStretch>& stretches,
                      const FootLockOptions& options = {},
                      const std::array<double, 2>& lowered = {0.0, 0.0});

}  // namespace mien::motion
