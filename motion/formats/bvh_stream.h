#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "motion/formats/bvh_hierarchy.h"
#include "motion/skeleton/pose.h"

namespace mien::motion {

/// The header of a BVH text, before its frames.
struct BvhHead {
  BvhHierarchy hierarchy;
  size_t claimed_frames = 0;  ///< the value of `Frames:`; arbitrary for a live source
  double frames_per_second = 30.0;
};

/// Parses a BVH text (bvh.h) incrementally, in chunks that may end anywhere. A frame is available
/// once its last line has ended; their number is not known before the end, so `Frames:` is only
/// reported. Keeps the header, and no more than one chunk and one frame.
///
/// Throws mien::Error with file, line and column as soon as the text is seen to be no BVH: as
/// `parse_bvh` but for the number of frames, and for a head of more than 4 MiB or a frame of more
/// than 64 characters a number (and 4 KiB), which no source sends.
class BvhStream {
 public:
  explicit BvhStream(std::string file_name) : file_(std::move(file_name)) {}

  /// Takes the next piece of the text.
  void push(std::string_view piece);

  /// End of the input: a last line without a line end is complete. Throws if the header or a frame
  /// is incomplete.
  void finish();

  /// The header; empty until "Frame Time:" and its number have been parsed.
  const std::optional<BvhHead>& head() const { return head_; }

  /// The next available frame, if any.
  std::optional<Pose> next();

 private:
  std::optional<std::string_view> next_line();
  void read_head();
  void drop(size_t count);

  std::string file_;
  std::string text_;    ///< input that has not been parsed yet
  size_t seen_ = 0;     ///< how much of it was scanned, in whole lines
  size_t numbers_ = 0;  ///< words in those lines, once the header is complete
  int first_line_ = 1;  ///< number of the line that `text_` begins with
  bool finished_ = false;
  bool knows_kind_ = false;  ///< the first word was HIERARCHY
  bool has_label_ = false;   ///< a line that begins with "Frame Time" was seen
  std::optional<BvhHead> head_;
  Pose before_;  ///< the pose before a frame's channels are applied
};

}  // namespace mien::motion
