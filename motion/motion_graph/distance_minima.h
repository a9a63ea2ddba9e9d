#pragma once

#include <span>
#include <vector>

#include "motion/motion_graph/point_cloud.h"

namespace mien::motion {

/// A local minimum of the distance between two windows.
struct DistanceMinimum {
  int clip_a = 0;
  int frame_a = 0;  ///< first of its window
  int clip_b = 0;   ///< ≥ clip_a
  int frame_b = 0;  ///< > frame_a in the same clip
  double metres = 0.0;
};

struct MinimaOptions {
  int window = 10;         ///< frames
  double most_metres = 1;  ///< minima above are left out
  int least_gap = 10;  ///< frames between windows of one clip, which are alike where they overlap
  int threads = 0;     ///< 0: one a processor
};

/// The local minima of `window_distance` over all pairs of windows, of which the pair's eight
/// neighbours are not less; of equal neighbours the first. Every window is compared with every
/// other: the products of all frames are made by matrix multiplication, tile by tile, and summed
/// along diagonals. Ordered by clips and frames; the same for any number of threads.
std::vector<DistanceMinimum> distance_minima(std::span<const PointCloud> clouds,
                                             const MinimaOptions& options);

}  // namespace mien::motion
