#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "motion/formats/mvnx/mvnx_file.h"

namespace mien::motion {

/// The segment of MVN's hands that a segment of this label hangs on: "LeftHand" of "LeftCarpus",
/// "LeftSecondPP" of "LeftSecondMP"; empty for a label that is none of a hand's.
std::string parent_in_mvn_hand(std::string_view label);

/// Adds the tracked fingers of a subject, whose segments are named, to its segments, frame by frame
/// and in the world. A hand whose carpus is near the world's origin, and not near its hand, is
/// taken to be seen from that hand. Hands of which numbers are missing, or that are nowhere near
/// either, are left out, and `notes` says so.
void add_tracked_hands(MvnxSubject& subject, std::vector<std::string>& notes);

}  // namespace mien::motion
