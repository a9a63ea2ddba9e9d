#pragma once

#include <optional>
#include <string>

#include "motion/fitting/fit.h"
#include "motion/points/point_recording.h"
#include "motion/skeleton/recording.h"

namespace mien::motion {

/// A recording of points as a motion that figures of every kind can show.
struct RecordedPoints {
  /// With `Recording::markers`: the points themselves, gaps filled as for the fit.
  Recording recording;
  std::optional<FittedMotion> fit;  ///< empty if the points could not be fitted to a body
  std::string rejection;            ///< why not, as a sentence; else empty
};

/// Fits the body to the points (fit.h); of several people whose points are together, named
/// "person:point", to those of the first whose points suffice. If that is not possible, the figure
/// is a single joint in their centre, so that the points can still be shown, and a note says why.
/// Notes are those of the reader and of the fit, with its warnings. Throws mien::Error if there are
/// no frames or points.
RecordedPoints recorded_points(const PointRecording& points);

}  // namespace mien::motion
