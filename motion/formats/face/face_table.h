#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "motion/formats/face/face_track.h"

namespace mien::motion {

/// Reads a table of facial weights: a CSV or TSV file with a row for each moment, a column of times
/// and a column for each expression, with numbers from 0 to 1. The first row is at time 0.
///
/// - Times are in a column `time`, `time_s`, `seconds` or `timestamp` (seconds), `frame` (numbers
/// of
///   frames) or `Timecode` (hours:minutes:seconds:frames, as Live Link Face writes them for ARKit),
///   and increase. Names are compared without regard to case.
/// - Frames are counted at `frames_per_second`, which is refused for times in seconds. Without it,
///   those of a timecode are counted at 24, 25, 30, 50 or 60 a second, the least of these that the
///   numbers within a second allow, or at 60 if the table has no whole second.
/// - Columns of Live Link Face that are not weights are skipped: the count of blend shapes, and the
///   angles of head and eyes.
///
/// Throws mien::Error with line and column for anything else.
FaceTrack read_face_table(const std::filesystem::path& path,
                          std::optional<double> frames_per_second);

/// As `read_face_table`, for a table in memory.
FaceTrack parse_face_table(std::string_view text, const std::string& file_name,
                           std::optional<double> frames_per_second);

}  // namespace mien::motion
