#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "motion/formats/bvh/bvh_hierarchy.h"
#include "motion/skeleton/pose.h"

namespace mien::motion {

/// The header of a BVH text, before its frames.
struct BvhHead {
  BvhHierarchy hierarchy;
  size_t claimed_frames = 0;  ///< the value of `Frames:`; arbitrary for a live source
  double frames_per_second = 30.0;
};

/// Parses a BVH text (bvh.h) incrementally, in chunks that may end anywhere. A frame is available
/// once its last line is complete. Because the number of frames is not known before the end, the
/// value of `Frames:` is reported but not checked. Memory is limited to the header, one chunk and
/// one frame.
///
/// Throws mien::Error with file, line and column as soon as the text is found not to be BVH: for
/// the same faults as `parse_bvh` except a wrong number of frames, and also for a second ROOT if no
/// figure is chosen, for a header of more than 4 MiB, or a frame of more than 4 KiB plus 64
/// characters per number.
class BvhStream {
 public:
  /// `subject` chooses one of several figures, as for `parse_bvh`.
  explicit BvhStream(std::string file_name, std::optional<std::string> subject = std::nullopt)
      : file_(std::move(file_name)), subject_(std::move(subject)) {}

  /// Adds the next chunk of the text.
  void push(std::string_view piece);

  /// Marks the end of the input; the last line need not end with a line break. Throws mien::Error
  /// if the header is incomplete; `next` throws for an incomplete last frame.
  void finish();

  /// The header; empty until `next` or `finish` has parsed "Frame Time:" and its number.
  const std::optional<BvhHead>& head() const { return head_; }

  /// The next available frame, if any.
  std::optional<Pose> next();

 private:
  std::optional<std::string_view> next_line();
  void read_head();
  void drop(size_t count);

  std::string file_;
  std::optional<std::string> subject_;
  std::string text_;    ///< input that has not been parsed yet
  size_t seen_ = 0;     ///< number of characters of `text_` scanned so far, in whole lines
  size_t numbers_ = 0;  ///< number of words in these lines, once the header is complete
  int first_line_ = 1;  ///< line number of the first line of `text_`
  bool finished_ = false;
  bool knows_kind_ = false;  ///< the first word was HIERARCHY
  bool has_label_ = false;   ///< a line that begins with "Frame Time" has been read
  std::optional<BvhHead> head_;
  Pose before_;  ///< the initial pose to which the channels of each frame are applied
};

}  // namespace mien::motion
