#pragma once

#include "motion/skeleton/recording.h"

namespace mien::motion {

/// Whether a pose has the joint offsets of the first one, but for a ten-millionth of the longest.
/// Its own need not be kept then.
bool has_offsets_of(const Pose& first, const Pose& pose);

/// Gives the skeleton the joint offsets that change by no more than a millionth of the longest
/// offset over the poses; removes the offsets of the poses if none changes more. The first pose has
/// offsets; further poses without offsets have those of the first.
void settle_offsets(Recording& recording);

}  // namespace mien::motion
