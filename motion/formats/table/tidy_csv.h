#pragma once

#include <string>

#include "motion/points/point_recording.h"

namespace mien::motion {

/// The recording as a table with a row for each point of each frame: frame (from 0), time_s
/// (seconds since the first frame), point, x_m, y_m, z_m; the coordinates are empty where the point
/// is missing. Positions are in metres to 0.1 µm, times to 1 ns; zeros at the end are omitted. A
/// recording whose unit is not known (metres_per_unit is 0) has the columns x, y, z instead, with
/// the shortest decimals that read back as the same numbers. Fields are quoted as in RFC 4180;
/// lines end with LF. `parse_point_table` reads it.
///
/// The recording has at least one point and frame. The same recording always produces the same
/// text.
std::string to_tidy_csv(const PointRecording& recording);

/// The description of that table, as JSON to be written beside it: the columns with their units,
/// and what point_description.h adds; `axes` says what they are.
std::string tidy_csv_sidecar(const PointRecording& recording,
                             const std::string& axes = "as in the source");

}  // namespace mien::motion
