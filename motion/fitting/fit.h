#pragma once

#include <optional>
#include <string>
#include <vector>

#include "motion/points/point_axes.h"
#include "motion/points/point_recording.h"
#include "motion/skeleton/clip.h"

namespace mien::motion {

struct FitOptions {
  double max_gap_seconds = 0.2;  ///< longest gap of a point that is filled (gaps.h)
  double warned_residual_mm = 40.0;
};

enum class PointUse {
  used,
  missing,  ///< in all frames of the clip
  unknown,  ///< its name is not one of the recognised set
};

/// How one point of the recording was used.
struct FittedPoint {
  std::string name;
  std::string role;  ///< "left outer knee"; empty if unknown
  PointUse use = PointUse::unknown;
  /// Root mean square distance between the point as measured and as the fitted body carries it, in
  /// the frames in which it was seen; 0 unless used.
  double residual_mm = 0.0;
  double missing_share = 0.0;  ///< of all frames, before filling
  double filled_share = 0.0;   ///< of all frames
};

/// A recording of points as a motion of the canonical body.
struct FittedMotion {
  /// Metres, +Y up, floor at 0; horizontal places and headings as recorded. The body has the
  /// subject's bone lengths.
  Clip clip;
  std::string marker_set;  ///< "Plug-in Gait"
  PointAxes axes;
  /// How far the motion was moved up so that the feet stand on the floor, metres.
  double raised = 0.0;
  int first_frame = 0;  ///< frame of the recording that is the clip's first
  std::vector<FittedPoint> points;
  /// Root mean square over the points of each frame of the clip; none where no point was seen.
  std::vector<std::optional<double>> frame_residual_mm;
  double residual_mm = 0.0;           ///< root mean square over all points and frames
  std::vector<std::string> notes;     ///< what was found and decided, as sentences
  std::vector<std::string> warnings;  ///< what the user should look at, as sentences
};

/// Fits the canonical body to the points: joint centres (body_tracks.h), bone lengths
/// (fitted_proportions.h), rotations bone by bone (initial_poses.h), then a least-squares pass over
/// all points (least_squares_pass.h). Frames before the pelvis is first seen and after it is last
/// seen are left out, with a note. Parts without points stay at rest, arms hang; each is a warning.
///
/// Throws mien::Error if the names are not those of a known set, if points that a body needs are
/// missing (hips, knees and ankles at the least), and if the pelvis or a leg is never seen.
FittedMotion fit_body(const PointRecording& recording, const FitOptions& options = {});

}  // namespace mien::motion
