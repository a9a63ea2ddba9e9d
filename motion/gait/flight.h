#pragma once

#include <vector>

#include "motion/gait/foot_plant.h"
#include "motion/skeleton/clip.h"

namespace mien::motion {

/// A stretch between two plants in which no foot touches the floor and the body is up: running.
struct Flight {
  int first = 0;
  int last = 0;                ///< included
  bool takes_off_left = true;  ///< the foot that left the floor
  bool lands_left = true;
};

/// Gaps of at least 0.06 s between the plants of a clip that does not loop, in which the pelvis is
/// higher than over 0.4 s on either side and, where they last 0.25 s, falls. (In walking it is
/// lowest between two single supports, where a strict judgement of contact may also leave a gap.)
std::vector<Flight> flights(const Clip& clip, const std::vector<FootPlant>& plants);

}  // namespace mien::motion
