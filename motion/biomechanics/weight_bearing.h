#pragma once

#include <vector>

#include "motion/biomechanics/subject.h"
#include "motion/gait/foot_plant.h"

namespace mien::motion {

/// Which parts of the body bear its weight, frame by frame.
struct WeightBearing {
  std::vector<bool> left;  ///< the left foot bears weight
  std::vector<bool> right;
  std::vector<bool> planted;    ///< one of the feet is planted
  std::vector<bool> elsewhere;  ///< a knee, a hand or the pelvis rests on the floor
  std::vector<bool> falls;      ///< free fall: nothing bears weight, as in running or jumping

  /// Whether nothing bears the body's weight although it is not in free fall.
  bool is_unsupported(int frame) const {
    return !left[frame] && !right[frame] && !elsewhere[frame] && !falls[frame];
  }
};

/// Weight bearing of a motion. A foot bears while it is planted (contact.h). Where neither is
/// planted although the body is not in free fall, the slower foot near the floor bears, and the
/// other one too if it is about as slow: skating feet count as standing. The body is in free fall
/// while its ground reaction force, from the acceleration of its centre of mass below 6 Hz, is less
/// than half of its weight.
WeightBearing weight_bearing_of(const LintSubject& subject);

/// The intervals in which a foot bears weight, by time; those shorter than 0.1 s are omitted.
std::vector<FootPlant> weight_bearing_feet(const WeightBearing& bearing, double frames_per_second);

/// The joints other than the feet on which the body rests in a frame: knees, wrists and pelvis at
/// the heights of kneeling, crawling and sitting on the floor.
std::vector<BodyJoint> other_contacts(const LintSubject& subject, int frame);

}  // namespace mien::motion
