#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "motion/math/rotation.h"
#include "motion/skeleton/skeleton.h"
#include "motion/text/text_cursor.h"

namespace mien::motion {

/// A channel: one number of each BVH frame.
struct BvhChannel {
  int joint = 0;  ///< −1: of another figure, so the number is passed over
  Axis axis = Axis::x;
  bool rotation = false;  ///< true: degrees about the axis; false: the coordinate along it
};

/// The HIERARCHY section of a BVH file: one figure, and the numbers of any others.
struct BvhHierarchy {
  Skeleton skeleton;
  std::vector<BvhChannel> channels;   ///< in the order of the numbers of a frame
  std::vector<std::string> subjects;  ///< the figures' names, those of their roots, if several
  size_t chosen = 0;                  ///< index of this figure in `subjects`
};

/// The text with its comments replaced by blanks, so that positions in the text are preserved. A
/// comment begins with '#' or '//', at the start of a line or after a blank, and extends to the end
/// of the line. Lines that name a joint have no comments.
std::string without_bvh_comments(std::string_view text);

/// Which figure of several is wanted. `may_choose` false: a file of several is refused.
struct BvhChoice {
  std::optional<std::string> subject = std::nullopt;  ///< name or number, from 1; else the first
  bool may_choose = true;
};

/// Parses the text from HIERARCHY up to and including MOTION. Throws mien::Error.
BvhHierarchy parse_bvh_hierarchy(TextCursor& cursor, const BvhChoice& choice = {});

/// Whether the figure has a channel.
bool has_channels(const BvhHierarchy& hierarchy);

}  // namespace mien::motion
