#pragma once

#include "motion/fitting/body_tracks.h"

namespace mien::motion {

/// Fills in the tracks of pelvis and legs, and the scale (body_tracks.h).
void add_pelvis_and_legs(const PointTracks& points, BodyTracks& body);

}  // namespace mien::motion
