#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "motion/math/rotation.h"
#include "motion/skeleton/skeleton.h"
#include "motion/text/text_cursor.h"

namespace mien::motion {

/// A channel: one number of each BVH frame.
struct BvhChannel {
  int joint = 0;
  Axis axis = Axis::x;
  bool rotation = false;  ///< true: degrees about the axis; false: the coordinate along it
};

/// The HIERARCHY section of a BVH file.
struct BvhHierarchy {
  Skeleton skeleton;
  std::vector<BvhChannel> channels;  ///< in the order of the numbers of a frame
};

/// The text with its comments replaced by blanks, so that positions in the text are preserved. A
/// comment begins with '#' or '//', at the start of a line or after a blank, and extends to the end
/// of the line. Lines that name a joint have no comments.
std::string without_bvh_comments(std::string_view text);

/// Parses the text from HIERARCHY up to and including MOTION. Throws mien::Error.
BvhHierarchy parse_bvh_hierarchy(TextCursor& cursor);

}  // namespace mien::motion
