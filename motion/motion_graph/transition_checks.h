#pragma once

#include <array>
#include <vector>

#include "motion/motion_graph/distance_minima.h"
#include "motion/motion_graph/motion_graph.h"

namespace mien::motion {

/// Whether each foot (right, left) is planted, by clip and frame of a graph.
using FootContacts = std::vector<std::vector<std::array<bool, 2>>>;

FootContacts foot_contacts(const MotionGraph& graph);

/// Share of the frames in which a foot's contact differs between the two windows; the larger of
/// both feet.
double contact_change(const FootContacts& contacts, const DistanceMinimum& minimum, int window);

/// Mean difference, radians, between the facing directions of the pelvis in the transition's two
/// windows, the second clip being rotated by `turn`.
double facing_change(const MotionGraph& graph, const GraphTransition& transition);

/// Largest excess, over the frames of the blend, of the pelvis' rotation per frame over that of
/// both motions, radians.
double turn_beyond_motions(const MotionGraph& graph, const GraphTransition& transition);

}  // namespace mien::motion
