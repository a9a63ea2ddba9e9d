#pragma once

#include <span>
#include <vector>

#include "motion/skeleton/clip.h"

namespace mien::motion {

/// Cuts the clips of several people in one recording to the frames that all of them have, so that
/// frame i is the same moment in all. `first_frames` are the frames of the recording with which the
/// clips begin. Returns false, and changes nothing, if there is no such frame.
[[nodiscard]] bool cut_to_simultaneous_frames(std::span<Clip> clips,
                                              std::span<const int> first_frames);

}  // namespace mien::motion
