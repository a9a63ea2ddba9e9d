#pragma once

#include "motion/fitting/point_tracks.h"

namespace mien::motion {

/// The recording with the points of a segment that are not seen in a frame where they must be by
/// the segment's other points: those of a pelvis of which one marker is hidden, however long.
/// Three other points of the segment must be seen, not nearly on a line, and fit the segment's
/// shape (its mean over the recording) to 20 mm, root mean square. The rest stays as it is.
/// For finding where segments are; such points are not measurements.
PointRecording with_segments_completed(const PointTracks& points);

}  // namespace mien::motion
