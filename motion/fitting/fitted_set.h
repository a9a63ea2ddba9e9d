#pragma once

#include <string>

#include "motion/points/marker_sets.h"
#include "motion/points/point_recording.h"

namespace mien::motion {

/// The marker set of the one person to whom a body is fitted.
struct FittedSet {
  MarkerSet set;        ///< the roles of other people's points are empty
  std::string subject;  ///< the first person of several whose points suffice; empty for only one
};

/// What the message of a recording that cannot be fitted says is needed.
std::string points_a_body_needs();

/// Throws mien::Error if the points are no known set or do not show pelvis, knees and ankles.
FittedSet fitted_set(const PointRecording& recording);

}  // namespace mien::motion
