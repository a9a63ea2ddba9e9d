#pragma once

#include <array>
#include <vector>

#include "motion/motion_graph/distance_minima.h"
#include "motion/motion_graph/motion_graph.h"

namespace mien::motion {

/// Whether each foot (right, left) is planted, by clip and frame of a graph.
using FootContacts = std::vector<std::vector<std::array<bool, 2>>>;

FootContacts foot_contacts(const MotionGraph& graph);

/// Share of the frames in which a foot is planted in only one of the two windows; of the two feet's
/// shares, the larger one.
double contact_change(const FootContacts& contacts, const DistanceMinimum& minimum, int window);

/// Mean difference, radians, between the facing directions of the pelvis in the transition's two
/// windows, with the second clip rotated by the transition's `turn`.
double facing_change(const MotionGraph& graph, const GraphTransition& transition);

/// By how many radians per frame the pelvis rotates faster in the blend than in the faster of the
/// two motions; maximum over the frames of the blend, at least 0.
double turn_beyond_motions(const MotionGraph& graph, const GraphTransition& transition);

}  // namespace mien::motion
