#pragma once

#include <string>

#include "motion/points/point_recording.h"

namespace mien::motion {

/// How the space of a recording lies: which way is up, what a unit is and where the floor is.
struct PointAxes {
  std::string up = "+Y";         ///< of the file's axes: "+X", "-X", "+Y", "-Y", "+Z" or "-Z"
  Quat turn = Quat::Identity();  ///< from the file's axes to +Y up
  double metres_per_unit = 1.0;
  double floor = 0.0;            ///< height of the floor in the file, along `up`, metres
  bool is_unit_guessed = false;  ///< the file states no unit
  bool is_up_assumed = false;    ///< neither names nor data tell which way is up (upward.h)
  bool is_up_stated = false;     ///< the file alone tells which way is up
  bool is_up_by_floor = false;   ///< the body lies or is upside down: the floor is not at its feet
  std::string note;              ///< a sentence about what is uncertain; may be empty
};

/// Finds the axes by the data; those that the file states are often wrong.
///
/// Up: by the names of the points, else by the shape of the cloud, else as the file states, else as
/// is usual in the format (upward.h); then it is assumed, and the note says so. The note also says
/// where the points contradict the file's statement. People who lie, or in C3D and TRC files
/// stand on their hands, are recognized by the floor: +Y or +Z is up if the points begin at its
/// zero (below) in all frames, but not at that of the body's own axis, and the body extends along
/// it by less than half of its length or is upside down, and it does not stand along the usual axis
/// of the format or the stated one; the note says so. Unit: as the file states it, otherwise the
/// one in which the body is of human height (unit_guess.h), or 0.5–2.5 m tall in metres,
/// centimetres or millimetres. Floor: the file's zero if the lowest point (3rd percentile over the
/// frames) is within −0.02 and 0.12 m of it, otherwise the height of that point.
PointAxes point_axes(const PointRecording& recording);

/// The recording in metres with +Y up and the floor at 0. Horizontal places and headings stay as
/// recorded: Z-up (x, y, z) becomes (x, z, −y).
PointRecording in_metres_y_up(PointRecording recording, const PointAxes& axes);
PointRecording in_metres_y_up(PointRecording recording);

}  // namespace mien::motion
