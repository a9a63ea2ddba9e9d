#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "motion/formats/mvnx/mvnx_file.h"
#include "motion/text/text_cursor.h"

namespace mien::motion {

/// The segments of one person as a tree.
struct MvnxTree {
  std::vector<std::size_t> segments;  ///< of the subject, parents first
  std::vector<int> parents;  ///< for each, its parent's index in `segments`; −1: the root
  std::vector<std::string> left_out;  ///< labels of segments that hang on no joint
};

/// Gives a subject without `segments` the labels of MVN's 23 segments, in MVN's order. Throws
/// mien::Error if it has another number.
void name_segments(const TextCursor& cursor, std::size_t count, MvnxSubject& subject);

/// The tree that the joints make of the segments, or without joints that of MVN's own 23. The root
/// is the segment without a parent from which the most others hang. Throws mien::Error if there is
/// none or if a segment has two parents.
MvnxTree mvnx_tree(const TextCursor& cursor, const MvnxSubject& subject);

}  // namespace mien::motion
