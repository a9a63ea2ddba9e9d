#pragma once

#include "motion/fitting/track.h"
#include "motion/points/marker_sets.h"
#include "motion/points/point_recording.h"

namespace mien::motion {

/// The points of a recording (metres, +Y up) by their roles.
struct PointTracks {
  const PointRecording& recording;
  const MarkerSet& set;

  std::size_t frame_count() const { return static_cast<std::size_t>(recording.frame_count()); }

  /// The point of a role; the mean if several points have it, known where all of them are that
  /// are seen in any frame.
  Track of(Landmark landmark, Side side = Side::middle) const;

  Track of_point(int point) const;
};

}  // namespace mien::motion
