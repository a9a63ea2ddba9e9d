#pragma once

#include <array>
#include <vector>

#include "motion/motion_graph/distance_minima.h"
#include "motion/motion_graph/motion_graph.h"

namespace mien::motion {

/// Whether each foot (right, left) stands, by clip and frame of a graph.
using FootStands = std::vector<std::vector<std::array<bool, 2>>>;

FootStands foot_stands(const MotionGraph& graph);

/// Share of the frames of both windows, foot by foot, in which it stands in one and not in the
/// other: that of the foot for which it is more.
double contact_change(const FootStands& stands, const DistanceMinimum& minimum, int window);

/// Mean difference, radians, between where the pelvis faces in the window of the transition's
/// second clip, turned by its `turn`, and in that of the first.
double facing_change(const MotionGraph& graph, const GraphTransition& transition);

/// How much farther the pelvis turns in some frame of the blend than in the same frame of either
/// motion, radians.
double turn_beyond_motions(const MotionGraph& graph, const GraphTransition& transition);

}  // namespace mien::motion
