#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "motion/formats/bvh_hierarchy.h"
#include "motion/skeleton/pose.h"

namespace mien::motion {

/// What stands before the frames of a BVH text.
struct BvhHead {
  BvhHierarchy hierarchy;
  size_t claimed_frames = 0;  ///< what `Frames:` says; of a live source, anything
  double frames_per_second = 30.0;
};

/// Reads a BVH text (bvh.h) while it comes, in pieces that may end anywhere. A frame is there once
/// its last line has ended; how many there are is not known before the end, so `Frames:` is only
/// reported. Holds the head, then no more than one piece and one frame.
///
/// Throws mien::Error with file, line and column as soon as the text is seen to be no BVH: as
/// `parse_bvh` but for the number of frames, and for a head of more than 4 MiB or a frame of more
/// than 64 characters a number (and 4 KiB), which no source sends.
class BvhStream {
 public:
  explicit BvhStream(std::string file_name) : file_(std::move(file_name)) {}

  /// Takes the next piece of the text.
  void push(std::string_view piece);

  /// Nothing more comes: a last line without an end is whole. Throws when the head or a frame is
  /// not.
  void finish();

  /// Empty until "Frame Time:" and its number have come.
  const std::optional<BvhHead>& head() const { return head_; }

  /// The next frame that is there.
  std::optional<Pose> next();

 private:
  std::optional<std::string_view> take_line();
  void read_head();
  void drop(size_t count);

  std::string file_;
  std::string text_;    ///< what has come and was not read yet
  size_t seen_ = 0;     ///< so much of it in whole lines that were looked at
  size_t numbers_ = 0;  ///< words in those lines, once the head is there
  int first_line_ = 1;  ///< number of the line that `text_` begins with
  bool finished_ = false;
  bool knows_kind_ = false;  ///< the first word was HIERARCHY
  bool has_label_ = false;   ///< a line that begins with "Frame Time" was seen
  std::optional<BvhHead> head_;
  Pose before_;  ///< what a frame's numbers are put to
};

}  // namespace mien::motion
