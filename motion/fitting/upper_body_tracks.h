#pragma once

#include "motion/fitting/body_tracks.h"

namespace mien::motion {

/// Fills in the tracks of trunk, arms and head (body_tracks.h); needs those of the pelvis and the
/// scale.
void add_upper_body(const PointTracks& points, BodyTracks& body);

/// The direction in which the trunk rises from the pelvis, by the points above it that are there:
/// from `base` to the neck or the middle of the shoulders.
Track trunk_direction(const PointTracks& points, const Track& base);

}  // namespace mien::motion
