#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "motion/math/geometry.h"

namespace mien::motion {

/// The points of a recording in the space of a motion (skeleton/clip.h): metres, +Y up, the floor
/// at y = 0, frame by frame. They are read and attached with skeleton/clip_markers.h.
struct Markers {
  std::vector<std::string> points;  ///< name of each point; all differ and none is empty
  /// Frame by frame, a position for each point; the zero vector where it is not known.
  std::vector<Vec3> positions;
  std::vector<bool> seen;        ///< whether the point was recorded; as long as `positions`
  std::vector<bool> filled;      ///< not seen, but estimated within a gap; as long as `positions`
  std::uint64_t motion_key = 0;  ///< of the motion that they belong to (attach)

  int point_count() const { return static_cast<int>(points.size()); }
  int frame_count() const {
    return points.empty() ? 0 : static_cast<int>(positions.size() / points.size());
  }
  /// Index of a point of a frame in `positions`, `seen` and `filled`.
  std::size_t at(int frame, int point) const {
    return static_cast<std::size_t>(frame) * points.size() + static_cast<std::size_t>(point);
  }
  bool is_known(std::size_t index) const { return seen[index] || filled[index]; }
};

/// For each point, the one of the other side of the body by its name, or itself if there is none:
/// "LASI" and "RASI", "L.Heel" and "R.Heel", "knee_l" and "knee_r", "LeftWrist" and "RightWrist".
std::vector<int> opposite_points(const std::vector<std::string>& points);

/// The markers with each point's position, and whether it is known, that of the opposite point.
Markers with_sides_exchanged(const Markers& markers);

/// One position per frame where those of `known` are `path`'s: straight lines join them, and the
/// ends keep the nearest one. Both are equally long; at least one is known.
std::vector<Vec3> bridged(std::vector<Vec3> path, const std::vector<bool>& known);

}  // namespace mien::motion
