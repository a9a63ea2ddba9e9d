#pragma once

#include <span>

#include "motion/motion_graph/distance_minima.h"
#include "motion/motion_graph/motion_graph.h"

namespace mien::motion {

/// Builds the transitions, nodes and edges of a graph that already has its clips and window, from
/// the minima of at most `threshold_m`, and keeps only the largest strongly connected component.
/// Returns the number of frames on the remaining edges; if it is 0, the graph has no edges.
int connect(MotionGraph& graph, std::span<const DistanceMinimum> minima, double threshold_m);

}  // namespace mien::motion
