#pragma once

#include "motion/skeleton/recording.h"

namespace mien::motion {

/// Gives the skeleton the joint offsets that change by no more than a millionth of the longest
/// offset over the poses, all of which have offsets; removes the offsets of the poses if none
/// changes more.
void settle_offsets(Recording& recording);

}  // namespace mien::motion
