#pragma once

#include <span>
#include <vector>

#include "motion/fitting/attachments.h"

namespace mien::motion {

/// Moves the poses so that the attached points come as near as possible to where they were measured
/// (global optimisation, Lu and O'Connor 1999), with bone lengths kept.
///
/// Per frame, minimises over root position and joint rotations: squared distances of the points
/// (standard deviation 10 mm; farther than 30 mm they count less, as 30 mm/distance) + squared
/// turns from the given poses (0.5 rad), which decide what the points leave open + squared turns
/// from the mean of the neighbouring frames (50 rad/s² over a frame, at least 0.02 rad). Three
/// Gauss–Newton steps, all frames at once with the neighbours of the step before; 15 in frames in
/// which a point is hidden or still farther than 30 mm, whose first poses may be far from the
/// points. Bounded and deterministic.
std::vector<Pose> least_squares_pass(const PointTracks& points, const Skeleton& body,
                                     std::span<const Attachment> attached,
                                     const std::vector<Pose>& poses, const FrameRange& range);

}  // namespace mien::motion
