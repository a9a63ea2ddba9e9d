#pragma once

#include <span>

#include "motion/motion_graph/distance_minima.h"
#include "motion/motion_graph/motion_graph.h"

namespace mien::motion {

/// Gives the graph, whose clips and window are set, the transitions of the minima within a
/// threshold, its nodes and edges, and leaves out what is not in the largest strongly connected
/// component. Returns the number of frames on the edges that are left; 0 leaves the graph without
/// edges.
int connect(MotionGraph& graph, std::span<const DistanceMinimum> minima, double threshold_m);

}  // namespace mien::motion
