#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "motion/math/geometry.h"

namespace mien::motion {

/// A rigid part of the body.
struct MvnxSegment {
  std::string label;                   ///< "RightUpperArm"
  std::optional<Vec3> farthest_point;  ///< of its `points`, in its frame, metres
};

/// A joint connects two segments, given by their labels.
struct MvnxJoint {
  std::string parent;
  std::string child;
};

/// The finger tracking of one hand; empty vectors where a file has none.
struct MvnxHand {
  std::vector<MvnxSegment> segments;
  std::vector<double> orientations;  ///< frame by frame
  std::vector<double> positions;     ///< frame by frame
};

/// What an MVNX file says of one person. Counts and numbers have not been checked, except that each
/// frame has as many numbers as the first.
struct MvnxSubject {
  std::string label;
  std::size_t place = 0;    ///< index in the text of the subject's tag
  double frame_rate = 0.0;  ///< 0: not stated
  std::vector<MvnxSegment> segments;
  std::vector<MvnxJoint> joints;
  std::vector<std::size_t> frames;   ///< of type "normal": index in the text of each one's tag
  std::vector<double> orientations;  ///< frame by frame
  std::vector<double> positions;     ///< frame by frame; may be empty
  std::array<MvnxHand, 2> hands;     ///< left, right; their numbers are not compared
  std::vector<double> times;         ///< milliseconds, a number a frame; empty unless all have one
};

/// Parses the text of an MVNX file: all people, at least one. Throws mien::Error with line and
/// column.
std::vector<MvnxSubject> parse_mvnx_subjects(std::string_view text, const std::string& file_name);

}  // namespace mien::motion
