#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "motion/skeleton/pose.h"
#include "motion/skeleton/skeleton.h"

namespace mien::motion {

/// Writes BVH text incrementally, as `to_bvh` (bvh.h): the header, then frame by frame.
class BvhText {
 public:
  /// `moving`: the joints whose offsets change over the poses; empty: none.
  explicit BvhText(Skeleton skeleton, std::vector<bool> moving = {});

  /// The header from HIERARCHY to Frame Time; `frames` is the value of `Frames:`.
  std::string head(std::string_view frames, double frames_per_second) const;

  /// Appends one line, with angles continuous to those of the frame before.
  void append_frame(std::string& text, const Pose& pose);

 private:
  Skeleton skeleton_;
  std::vector<bool> moving_;
  std::vector<size_t> order_;  ///< joints in the order of the text
  std::vector<Vec3> angles_;   ///< of the last frame, radians
};

}  // namespace mien::motion
