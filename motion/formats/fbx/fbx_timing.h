#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "motion/formats/fbx/fbx_scene.h"
#include "motion/formats/reading/read_options.h"

namespace mien::motion {

/// The times at which a motion is sampled.
struct FbxTiming {
  std::int64_t first = 0;  ///< ticks
  double frames_per_second = 30.0;
  std::size_t frames = 1;
};

/// The timing of a take, from the keys of an animation (that of the figure alone), the span that
/// the take states, and the file's time mode: see fbx.h. Adds sentences to `notes` if the keys or
/// the given rate differ from what the file states, or frames without keys are left out. Throws
/// mien::Error for a motion of more than an hour and for a given rate that is not from 1 to 1000.
FbxTiming fbx_timing(const FbxScene& scene, const FbxAnimation& animation,
                     const std::optional<FbxTake>& take, const ReadOptions& options,
                     std::vector<std::string>& notes);

/// The time of a frame, ticks.
std::int64_t time_of_frame(const FbxTiming& timing, std::size_t frame);

}  // namespace mien::motion
