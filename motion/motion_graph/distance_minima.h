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
  int frame_b = 0;  ///< at least frame_a + least_gap if both are in one clip
  double metres = 0.0;
};

struct MinimaOptions {
  int window = 10;         ///< frames
  double most_metres = 1;  ///< larger minima are omitted
  int least_gap = 10;  ///< least number of frames between the starts of two windows of one clip,
                       ///< since overlapping windows are similar anyway
  int threads = 0;     ///< 0: one per processor
};

/// Local minima of `window_distance` over all pairs of windows: pairs whose distance is at most
/// that of each of their eight neighbours (either window, or both, moved by a frame); of neighbours
/// with equal distances only the first counts. Ordered by clip_a, frame_a, clip_b, frame_b. The
/// result does not depend on the number of threads.
std::vector<DistanceMinimum> distance_minima(std::span<const PointCloud> clouds,
                                             const MinimaOptions& options);

}  // namespace mien::motion
