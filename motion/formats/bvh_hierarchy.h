#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "motion/math/rotation.h"
#include "motion/skeleton/skeleton.h"
#include "motion/text/text_cursor.h"

namespace mien::motion {

/// One number of each BVH frame.
struct BvhChannel {
  int joint = 0;
  Axis axis = Axis::x;
  bool rotation = false;  ///< degrees about the axis; else the coordinate along it
};

/// The HIERARCHY section of a BVH file.
struct BvhHierarchy {
  Skeleton skeleton;
  std::vector<BvhChannel> channels;  ///< in the order of a frame's numbers
};

/// The text with its comments (from '#' or '//' to the line's end) replaced by blanks, so that
/// positions stay.
std::string without_bvh_comments(std::string_view text);

/// Reads from HIERARCHY up to and with MOTION. Throws mien::Error.
BvhHierarchy parse_bvh_hierarchy(TextCursor& cursor);

}  // namespace mien::motion
