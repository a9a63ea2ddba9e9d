#pragma once

#include <vector>

#include "motion/biomechanics/lint_motion.h"
#include "motion/gait/foot_plant.h"

namespace mien::motion {

/// The parts of the body that bear its weight, in each frame.
struct WeightBearing {
  std::vector<bool> left;       ///< the left foot bears weight
  std::vector<bool> right;      ///< the right foot bears weight
  std::vector<bool> planted;    ///< at least one foot is planted
  std::vector<bool> elsewhere;  ///< a knee, a hand or the pelvis rests on the floor
  std::vector<bool> falls;      ///< the body is in free fall, as in running or jumping

  /// Whether nothing bears the weight in a frame although the body is not in free fall.
  bool is_unsupported(int frame) const {
    return !left[frame] && !right[frame] && !elsewhere[frame] && !falls[frame];
  }
};

/// Determines weight bearing in each frame. A foot bears weight while it is planted (contact.h).
/// Where neither foot is planted although the body is not in free fall and rests on nothing else,
/// the slower foot near the floor bears weight, and so does the other foot if it is near the floor
/// and not faster by more than 0.15 m/s; skating feet thus count as standing. The body is in free
/// fall while its vertical ground reaction force, computed from the acceleration of its centre of
/// mass low-pass filtered at `gait_cutoff_hz`, is less than half its weight.
WeightBearing weight_bearing_of(const LintMotion& motion);

/// The intervals in which a foot bears weight, in order of time; intervals shorter than 0.1 s are
/// omitted.
std::vector<FootPlant> weight_bearing_feet(const WeightBearing& bearing, double frames_per_second);

/// The joints other than those of the feet on which the body rests in a frame: knees, wrists and
/// pelvis at the low heights of kneeling, crawling and sitting on the floor.
std::vector<BodyJoint> other_contacts(const LintMotion& motion, int frame);

}  // namespace mien::motion
