#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "motion/skeleton/pose.h"
#include "motion/skeleton/skeleton.h"

namespace mien::motion {

/// BVH text piece by piece, as `to_bvh` (bvh.h) writes it: the head, then frame after frame.
class BvhText {
 public:
  /// `moving` tells the joints whose offsets change over the poses; none of them when empty.
  explicit BvhText(Skeleton skeleton, std::vector<bool> moving = {});

  /// From HIERARCHY to Frame Time, with what `Frames:` is to say.
  std::string head(std::string_view frames, double frames_per_second) const;

  /// One line; its angles run on from those of the frame before.
  void append_frame(std::string& text, const Pose& pose);

 private:
  Skeleton skeleton_;
  std::vector<bool> moving_;
  std::vector<size_t> order_;  ///< joints as they stand in the text
  std::vector<Vec3> angles_;   ///< of the last frame, radians
};

}  // namespace mien::motion
