#pragma once

#include <vector>

#include "motion/biomechanics/subject.h"
#include "motion/gait/foot_plant.h"

namespace mien::motion {

/// What carries the body, frame by frame.
struct Bearing {
  std::vector<bool> left;  ///< the foot bears on the floor
  std::vector<bool> right;
  std::vector<bool> planted;    ///< one of them stands still
  std::vector<bool> elsewhere;  ///< a knee, a hand or the seat rests on the floor
  std::vector<bool> falls;      ///< nothing bears: running or leaping, the body falls freely

  /// Whether nothing can be told to carry the body, though it does not fall.
  bool hangs(int frame) const {
    return !left[frame] && !right[frame] && !elsewhere[frame] && !falls[frame];
  }
};

/// A foot bears while it is planted (contact.h). Where neither is, though the body does not fall
/// freely, the foot bears that is stiller on the floor, however fast it slides there, and the other
/// too if it is about as still: feet that skate are no feet in the air. A body falls that presses
/// the floor with less than half of its weight by the acceleration of its centre of mass below 6
/// Hz.
Bearing bearing_of(const LintSubject& subject);

/// The stretches in which a foot bears, by time; shorter ones than 0.1 s are left out.
std::vector<FootPlant> bearing_feet(const Bearing& bearing, double frames_per_second);

/// The joints other than feet on which the body rests in a frame: knees, wrists and pelvis that are
/// as low as they are in kneeling, crawling and sitting on the floor.
std::vector<BodyJoint> other_rests(const LintSubject& subject, int frame);

}  // namespace mien::motion
