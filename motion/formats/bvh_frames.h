#pragma once

#include "motion/formats/bvh_hierarchy.h"
#include "motion/skeleton/pose.h"

namespace mien::motion {

// The lower half of a BVH file, piece by piece; see bvh.h for what is accepted. All of these throw
// mien::Error with file, line and column.

/// What "Frames:" claims, and where it does.
struct BvhFrameCount {
  size_t count = 0;
  size_t place = 0;  ///< index in the cursor's text
};

/// The line "Frames: n".
BvhFrameCount take_bvh_frame_count(TextCursor& cursor);

/// The line "Frame Time: s" as the frame rate that it was rounded from.
double take_bvh_frame_rate(TextCursor& cursor);

/// The pose that a frame's numbers are put to.
Pose bvh_pose_before_channels(const BvhHierarchy& hierarchy);

/// Puts one frame to a pose: numbers on one line or on several, to a line's end.
void take_bvh_frame(TextCursor& cursor, const BvhHierarchy& hierarchy, Pose& pose);

}  // namespace mien::motion
