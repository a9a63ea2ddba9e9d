#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "motion/skeleton/pose.h"
#include "motion/skeleton/skeleton.h"

namespace mien::motion {

/// Writes BVH text incrementally in the format of `to_bvh` (bvh.h): first the header, then each
/// frame.
class BvhText {
 public:
  /// `moving`: for each joint, whether frames include its offset; if empty, they include none.
  explicit BvhText(Skeleton skeleton, std::vector<bool> moving = {});

  /// The header from HIERARCHY to Frame Time; `frames` is the value of `Frames:`.
  std::string head(std::string_view frames, double frames_per_second) const;

  /// Appends one line, with angles continuous with those of the previous frame.
  void append_frame(std::string& text, const Pose& pose);

 private:
  Skeleton skeleton_;
  std::vector<bool> moving_;
  std::vector<size_t> order_;  ///< joints in the order of the text
  std::vector<Vec3> angles_;   ///< angles of the previous frame, radians
};

}  // namespace mien::motion
