#pragma once

#include <array>
#include <vector>

#include "motion/gait/foot_lock.h"

namespace mien::motion {

/// Position and orientation of a foot in one frame, world space.
struct FootPlace {
  Vec3 ankle;
  Quat rotation;
};

/// Target positions and orientations of a foot over an interval of frames. In a looping clip the
/// interval may extend past the end into the next cycle.
struct FootTrajectory {
  bool left = true;
  int first = 0;                  ///< frame of places.front()
  std::vector<FootPlace> places;  ///< one per frame
};

/// Moves the feet to given targets by leg IK. Beyond the ends of an interval, its corrections fade
/// over `blend_seconds` or, if that is shorter, half of the time to the next interval. The pelvis
/// is lowered smoothly where a leg cannot reach. Bones keep their lengths, and knees their planes;
/// knees bent backwards are bent forwards (after Kovar, Schreiner and Gleicher 2002). `lowered`
/// holds the metres by which the left and the right foot are lowered in all frames.
Clip with_feet_placed(const Clip& clip, const std::vector<FootTrajectory>& stretches,
                      const FootLockOptions& options = {},
                      const std::array<double, 2>& lowered = {0.0, 0.0});

}  // namespace mien::motion
