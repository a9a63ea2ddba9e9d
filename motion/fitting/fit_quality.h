#pragma once

#include <optional>
#include <string>
#include <vector>

namespace mien::motion {

/// Distance (root mean square) above which a point, or the whole body, counts as far from the
/// points to which the body was fitted; chosen for this project.
inline constexpr double far_from_points_mm = 40.0;

enum class PointUse {
  used,
  missing,  ///< in all frames of the clip
  unknown,  ///< its name is not one of the recognised set
};

/// Frames in a row in which a point was not recorded, counted from 0 in the recording.
struct PointGap {
  int first = 0;
  int past = 0;         ///< the frame after the last one
  bool filled = false;  ///< interpolated for the fit; otherwise the point was not used there

  friend bool operator==(const PointGap&, const PointGap&) = default;
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
  std::vector<PointGap> gaps;  ///< by time
  /// First and last frame of the recording in which it is more than `far_from_points_mm` away;
  /// empty if it never is.
  std::optional<int> first_far;
  int last_far = 0;
};

/// How well a body fits the points of a recording.
struct FitQuality {
  std::string marker_set;  ///< "Plug-in Gait"
  double frames_per_second = 30.0;
  int recorded_frames = 0;
  int first_frame = 0;  ///< frame of the recording that is the clip's first
  std::vector<FittedPoint> points;
  /// Root mean square over the points of each frame of the clip; none where no point was seen.
  std::vector<std::optional<double>> frame_residual_mm;
  double residual_mm = 0.0;  ///< root mean square over all points and frames
};

}  // namespace mien::motion
