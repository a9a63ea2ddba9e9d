#pragma once

#include <span>
#include <vector>

#include "motion/gestures/hand_hits.h"

namespace mien::motion {

/// The source frame of each frame of a hand that hits harder, for `retime`: before each hit the
/// hand lags and then arrives at twice its speed; after it, it leaves at a fifth of its speed and
/// catches up. The hits themselves stay where they are in time, and so does all that is more than
/// 0.2 s away from them, or beyond the turn between two hits. Never decreasing. `hits`: of one
/// hand, in the order of their frames.
std::vector<double> hard_hit_sources(std::span<const HandHit> hits, int frame_count,
                                     double frames_per_second, bool loops);

}  // namespace mien::motion
