#pragma once

#include <vector>

#include "motion/fitting/point_tracks.h"

namespace mien::motion {

/// The centre of the joint between two segments of which only markers on their skin are known: the
/// point that moves least in both (symmetrical centre of rotation estimation, Ehrig et al. 2006),
/// drawn towards `guess` in the directions that the motion does not determine, as along the axis of
/// a knee. `guess_weight`: of the guess relative to the motion's equations (mean square rotation,
/// rad²). Known where both segments are; unknown throughout if a segment has no frame with three
/// points that are not on a line.
Track functional_joint(const std::vector<Track>& upper, const std::vector<Track>& lower,
                       const Track& guess, double guess_weight);

/// Finds the knee and the ankle of one side by motion if they have neither a centre nor a point
/// beside the joint and three or more markers are on each segment.
void add_functional_joints(const PointTracks& points, Side side, const Track& hips, Track& knees,
                           Track& ankles);

}  // namespace mien::motion
