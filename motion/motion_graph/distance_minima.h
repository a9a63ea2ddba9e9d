#pragma once

#include <span>
#include <vector>

#include "motion/motion_graph/point_cloud.h"

namespace mien::motion {

/// A local minimum of the distance between two windows.
struct DistanceMinimum {
  int clip_a = 0;
  int frame_a = 0;  ///< first frame of its window
  int clip_b = 0;   ///< ≥ clip_a
  int frame_b = 0;  ///< > frame_a if both are in the same clip
  double metres = 0.0;
};

struct MinimaOptions {
  int window = 10;         ///< frames
  double most_metres = 1;  ///< larger minima are omitted
  int least_gap = 10;  ///< least number of frames between the starts of two windows of one clip,
                       ///< whose similarity would otherwise be that of overlapping windows
  int threads = 0;     ///< 0: one per processor
};

/// Local minima of `window_distance` over all pairs of windows: pairs whose eight neighbours are no
/// closer; of neighbours with equal distances only the first counts. All pairs of windows are
/// compared, using matrix products of the frames, computed in tiles and summed along diagonals.
/// Ordered by clips and frames; the result does not depend on the number of threads.
std::vector<DistanceMinimum> distance_minima(std::span<const PointCloud> clouds,
                                             const MinimaOptions& options);

}  // namespace mien::motion
