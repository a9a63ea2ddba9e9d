#pragma once

#include <array>
#include <vector>

#include "motion/motion_graph/distance_minima.h"
#include "motion/motion_graph/motion_graph.h"

namespace mien::motion {

/// Whether each foot (right, left) stands, by clip and frame of a graph.
using FootContacts = std::vector<std::vector<std::array<bool, 2>>>;

FootContacts foot_contacts(const MotionGraph& graph);

/// Share of the frames in which a foot's contact differs between the two windows; the larger of
/// both feet.
double contact_change(const FootContacts& contacts, const DistanceMinimum& minimum, int window);

/// Mean difference, radians, between where the pelvis faces in the window of the transition's
/// second clip, turned by its `turn`, and in that of the first.
double facing_change(const MotionGraph& graph, const GraphTransition& transition);

/// How much farther the pelvis turns in some frame of the blend than in the same frame of either
/// motion, radians.
double turn_beyond_motions(const MotionGraph& graph, const GraphTransition& transition);

}  // namespace mien::motion
