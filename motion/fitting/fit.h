#pragma once

#include <string>
#include <vector>

#include "motion/fitting/fit_quality.h"
#include "motion/points/point_axes.h"
#include "motion/points/point_recording.h"
#include "motion/skeleton/clip.h"

namespace mien::motion {

struct FitOptions {
  double max_gap_seconds = 0.2;  ///< longest gap of a point that is filled (gaps.h)
};

/// A recording of points as a motion of the canonical body.
struct FittedMotion : FitQuality {
  /// Metres, +Y up, floor at 0; horizontal places and headings as recorded. The body has the
  /// subject's bone lengths.
  Clip clip;
  PointAxes axes;
  /// How far the motion was moved up so that the feet stand on the floor, metres; the median if the
  /// frames were moved by different amounts.
  double raised = 0.0;
  /// How far each frame was moved up, metres.
  std::vector<double> raised_by_frame;
  /// The file has its positions relative to the hips (hip_origin.h): the motion is in place, and
  /// the lower foot is on the floor in each frame.
  bool is_relative_to_hips = false;
  std::vector<std::string> notes;     ///< what was found and decided, as sentences
  std::vector<std::string> warnings;  ///< what the user should look at, as sentences
};

/// Fits the canonical body to the points: joint centres (body_tracks.h), bone lengths
/// (fitted_proportions.h), rotations bone by bone (initial_poses.h), then a least-squares pass over
/// all points (least_squares_pass.h). Frames before the pelvis is first seen and after it is last
/// seen are left out, with a note. Parts without points stay at rest, arms hang, and feet are
/// turned by the floor (feet_without_points.h); each is a warning.
///
/// Throws mien::Error if the names are not those of a known set, if points that a body needs are
/// missing (hips, knees and ankles at the least), and if the pelvis or a leg is never seen.
FittedMotion fit_body(const PointRecording& recording, const FitOptions& options = {});

}  // namespace mien::motion
