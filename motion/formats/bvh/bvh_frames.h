#pragma once

#include <optional>

#include "motion/formats/bvh/bvh_hierarchy.h"
#include "motion/skeleton/pose.h"

namespace mien::motion {

// Parsing of the MOTION section of a BVH file; see bvh.h for what is accepted. All parsing
// functions throw mien::Error with file, line and column.

/// The number of frames stated by "Frames:", and its position.
struct BvhFrameCount {
  size_t count = 0;
  size_t place = 0;  ///< index in the cursor's text
};

/// Parses the line "Frames: n".
BvhFrameCount parse_bvh_frame_count(TextCursor& cursor);

/// Parses the line "Frame Time: s" and returns the frame rate from which s was rounded; the `given`
/// one if the line is missing or s is no frame time.
double parse_bvh_frame_rate(TextCursor& cursor, std::optional<double> given = std::nullopt);

/// The initial pose to which the channels of each frame are applied.
Pose bvh_pose_before_channels(const BvhHierarchy& hierarchy);

/// Parses one frame into a pose: numbers on one or several lines, up to the end of a line.
void parse_bvh_frame(TextCursor& cursor, const BvhHierarchy& hierarchy, Pose& pose);

}  // namespace mien::motion
