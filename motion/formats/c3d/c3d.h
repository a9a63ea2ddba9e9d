#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "motion/formats/reading/read_options.h"
#include "motion/points/point_recording.h"
#include "motion/skeleton/recording.h"

namespace mien::motion {

/// Reads the points of a C3D file (c3d.org, "The C3D File Format: User Guide", Motion Lab Systems
/// 2008; checked with files of Vicon): integers or floats, written by Intel, DEC or MIPS
/// processors. Analog channels are skipped. Positions keep the unit (POINT:UNITS) and the axes of
/// the file.
///
/// - A point is missing in a frame if the file marks it so (the fourth value is negative), if a
///   coordinate is not finite, and if it is at exactly 0 0 0, whatever its fourth value: the format
///   sets invalid points to zero, and programs exist that do so without the mark (with a residual
///   of 0, which by the format means "interpolated or computed"). No measured point stays at the
///   origin to the last digit; a note tells how many were unmarked.
/// - The axis that is up is stated by POINT:Y_SCREEN, unless it is also that of POINT:X_SCREEN;
///   point_axes.h decides whether it counts.
/// - Frames, frame rate: c3d_layout.h. Names, people and what is left out: c3d_columns.h.
/// - Events are those of the EVENT group, or else of the header. Their times, which count from the
///   trial's frame 1, are converted to seconds since the first frame of the file; if more of them
///   then lie outside the file than before, they are left as they stand.
///
/// Throws mien::Error naming the file, and the byte where one is at fault, for anything that is not
/// a C3D file with points.
PointRecording parse_c3d(std::string_view bytes, const std::string& file_name,
                         const ReadOptions& options = {});

/// As `parse_c3d`, from a file.
PointRecording read_c3d(const std::filesystem::path& path, const ReadOptions& options = {});

/// Whether the bytes are a C3D file without points but with rotations of segments, as the
/// markerless system Theia3D writes. Never throws.
bool holds_c3d_rotations(std::string_view bytes);

/// Reads the rotations of segments (the ROTATION group) of a C3D file. In each frame a segment has
/// 17 floats: a 4 × 4 matrix from the segment to the laboratory, column by column, and a mark that
/// is negative if the segment was not found (C-Motion, "ROTATION data type", 2019). Checked on
/// synthetic files only.
///
/// Each segment becomes a joint at the segment's origin. Parents are those of Theia's model
/// (pelvis, torso, thighs, …) by the names of the segments, without "_4X4"; other segments are
/// children of the root, and "worldbody" and "pelvis_shifted" are left out. Segments are not linked
/// rigidly, so that every pose has `offsets`. Where a segment is missing, its motion is
/// interpolated or, before the first and after the last frame with it, held, with a note; a segment
/// that is missing throughout is left out. The unit is the file's, usually millimetres.
Recording parse_c3d_rotations(std::string_view bytes, const std::string& file_name,
                              const ReadOptions& options = {});

/// As `parse_c3d_rotations`, from a file.
Recording read_c3d_rotations(const std::filesystem::path& path, const ReadOptions& options = {});

}  // namespace mien::motion
