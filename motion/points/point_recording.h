#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "motion/math/geometry.h"

namespace mien::motion {

/// A named moment of a recording, such as a heel strike that the laboratory marked.
struct PointEvent {
  std::string label;     ///< "Foot Strike"
  std::string context;   ///< "Left", "Right", "General"; may be empty
  double seconds = 0.0;  ///< since the first frame; negative or beyond the end as in the file
};

/// Points over time, as read from a file: markers or joint centres without rotations, in the
/// file's own unit and axes.
struct PointRecording {
  std::string name;                 ///< file name without folder and extension
  std::string format;               ///< "c3d", "trc", "npy", …
  std::vector<std::string> points;  ///< name of each point; all differ and none is empty
  double frames_per_second = 30.0;
  /// Frame by frame, a position for each point; the zero vector where it is not `seen`.
  std::vector<Vec3> positions;
  std::vector<bool> seen;  ///< whether the point was found in the frame; as long as `positions`
  std::string unit;  ///< of the positions as the file states it: "mm", "m"; empty if it does not
  double metres_per_unit = 0.0;  ///< from `unit`; 0 if the file states none
  std::vector<PointEvent> events;
  std::vector<std::string> subjects;  ///< people that the file holds; empty if it does not tell
  std::string subject;                ///< the one whose points these are; empty: all
  std::vector<std::string> notes;     ///< choices and omissions of the reader, as sentences
  std::string
      stated_up;  ///< axis that is up as the file states it: "+Z", "-Y"; empty if it does not

  int point_count() const { return static_cast<int>(points.size()); }
  int frame_count() const {
    return points.empty() ? 0 : static_cast<int>(positions.size() / points.size());
  }
  /// Index of a point of a frame in `positions` and `seen`.
  std::size_t at(int frame, int point) const {
    return static_cast<std::size_t>(frame) * points.size() + static_cast<std::size_t>(point);
  }
};

}  // namespace mien::motion
