#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "motion/formats/reading/read_options.h"
#include "motion/points/point_recording.h"

namespace mien::motion {

/// Reads points over time from a text of rows and columns (CSV, TSV). Fields are separated by
/// commas, by semicolons (then numbers may have decimal commas) or by tabs; see table_rows.h for
/// quotes and comments. Layouts:
///
/// - wide: a row is a frame, with three columns for each point, named "nose_x", "nose.X", "nose x",
///   "x_nose" or "noseX" (column_name.h), in any order; or with the names of points in one row and
///   x, y, z in the row below it, as DeepLabCut, Anipose and Vicon Nexus write;
/// - long: a row is a point of a frame, with columns such as frame, point, x, y, z, and perhaps
///   time and subject, in any order;
/// - CSV of OptiTrack Motive (first cell "Format Version"): positions of markers, or if there are
///   none of bones; Length Units and Export Frame Rate of its first line;
/// - TSV of Qualisys Track Manager (rows NO_OF_FRAMES … MARKER_NAMES): millimetres; 0 0 0 is
/// missing.
///
/// A column of times gives the frame rate, and one of frame numbers or times the gaps
/// (frame_times.h). The description beside a long table that mien wrote ("walk.csv.json") gives the
/// rate where its rounded times do not contradict it, or with one frame. Cells that are empty, NaN,
/// NA or n/a are missing (table_cell.h); a point is seen only where all three are given. Columns
/// that are not understood are left out with a note. The unit is the one in the names of the
/// columns or the header; otherwise the recording has none. Without a header row, the points are
/// those of `options.joints`, three columns each.
///
/// Sources of the layouts: "Data Export: CSV" at docs.optitrack.com, and headers of files of both
/// programs quoted in public repositories.
///
/// Throws mien::Error with file, line and column for a cell that is not as its column says, times
/// that are not even, no rate, two-dimensional keypoints, and a file without points.
PointRecording read_point_table(const std::filesystem::path& path, const ReadOptions& options = {});

/// As `read_point_table`, for a text in memory. `file_name` is used in error messages and, without
/// folder and extension, as the name of the recording.
PointRecording parse_point_table(std::string_view text, const std::string& file_name,
                                 const ReadOptions& options = {});

}  // namespace mien::motion
