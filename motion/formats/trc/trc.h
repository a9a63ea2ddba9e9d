#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "motion/formats/reading/read_options.h"
#include "motion/points/point_recording.h"

namespace mien::motion {

/// Reads a TRC file (Track Row Column, of Motion Analysis; OpenSim's documentation, "Marker (.trc)
/// Files"; checked with nine files of OpenSim): tab-separated, a line that begins with
/// "PathFileType", a line of field names and one of their values, of which older files have fewer,
/// a line "Frame# Time" with the names of the points, a line "X1 Y1 Z1 …", and a row for each
/// frame. Names are in the order of their coordinates, with any number of empty cells between them.
/// Positions keep the unit ("Units") and the axes of the file.
///
/// - A point is missing in a frame if one of its cells is empty or NaN, if the row ends before it,
///   or if it is at exactly 0 0 0, which several converters write for missing points.
/// - People: where all points are named "person:point", `options.subject` chooses a person
///   (reading/points_of_subject.h).
/// - Frame rate and frames: from the column Time (trc_times.h), which is more reliable than the
///   header's DataRate, else `options.frames_per_second`. Frames that have no row are frames
///   without any point, with a note.
///
/// Throws mien::Error with file, line and column for anything else, for example a cell that is not
/// a number, more cells than points, or times that are not evenly spaced.
PointRecording parse_trc(std::string_view text, const std::string& file_name,
                         const ReadOptions& options = {});

/// As `parse_trc`, from a file.
PointRecording read_trc(const std::filesystem::path& path, const ReadOptions& options = {});

/// The recording as TRC text, in metres if that is its unit and otherwise in millimetres, to
/// 0.0001 mm. Missing points are empty cells. A seen point that would be written as 0 0 0 is
/// written at the smallest distance from it, since zeros mean a missing point. In names, control
/// characters are replaced by '_'. Events and subjects have no place in this format.
///
/// The same recording always produces the same text. Throws mien::Error if the recording has no
/// points, no frames, or no known unit.
std::string to_trc(const PointRecording& recording);

}  // namespace mien::motion
