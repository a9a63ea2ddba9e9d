#pragma once

#include <vector>

#include "motion/points/point_recording.h"

namespace mien::motion {

/// How much of a point is missing.
struct PointGaps {
  double missing_share = 0.0;        ///< of the frames, 0 to 1
  double longest_gap_seconds = 0.0;  ///< missing frames in a row divided by the frame rate
};

struct GapSummary {
  std::vector<PointGaps> points;  ///< in the order of the recording's points
  double missing_share = 0.0;     ///< of all points in all frames
  double longest_gap_seconds = 0.0;
};

GapSummary gaps_of(const PointRecording& recording);

struct FilledPoints {
  PointRecording recording;  ///< the filled values are `seen`
  std::vector<bool> filled;  ///< which values were filled, as long as `positions`
};

/// Fills the gaps of at most `max_gap_seconds` by a cubic spline through up to four values on
/// either side, a third of the gap apart, so that the noise of single frames is not magnified.
/// Longer gaps, and what is missing before a point's first value and after its last one, stay.
FilledPoints filled(const PointRecording& recording, double max_gap_seconds = 0.2);

}  // namespace mien::motion
