#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <variant>

#include "motion/formats/reading/read_options.h"
#include "motion/points/point_recording.h"
#include "motion/skeleton/recording.h"

namespace mien::motion {

/// What a motion file holds: rotations of joints, or points.
using FileContents = std::variant<Recording, PointRecording>;

/// The extension of a file name in lower case, without that of a compressed file, as in
/// `MotionFormat::ending` (motion_format.h): ".bvh" for "Walk.BVH" and "walk.bvh.gz".
std::string lower_case_ending(const std::filesystem::path& path);

/// The formats that can be read, can be written, or may contain several motions, as text: "BVH
/// (.bvh), Acclaim (.amc) or glTF (.gltf, .glb)".
std::string formats_read();
std::string formats_written();
std::string formats_with_takes();

/// Whether `read_motion` supports a file's extension.
bool is_motion_file(const std::filesystem::path& path);

/// Whether files with this extension are motions, wherever they are found
/// (`MotionFormat::is_of_motions`).
bool is_found_as_motion(const std::filesystem::path& path);

/// Reads a file in the format of its extension. Throws mien::Error if the file does not exist, its
/// extension is not supported, the reader of the format finds a fault, or a take or person is
/// chosen in a format whose files hold one.
FileContents read_file(const std::filesystem::path& path, const ReadOptions& options = {});

/// As `read_file`, as a motion: points are fitted to a body (fitting/recorded_points.h).
Recording read_motion(const std::filesystem::path& path, const ReadOptions& options);
Recording read_motion(const std::filesystem::path& path,
                      const std::optional<std::string>& take = std::nullopt);

/// As `read_motion`; an empty `take` selects the first motion.
Recording read_take(const std::filesystem::path& path, const std::string& take);

/// Whether a file with this extension may contain several motions (takes).
bool may_hold_takes(const std::filesystem::path& path);

/// Writes a motion in the format of the file's extension (written_motion.h): the joints with their
/// rotations or, in formats of points, their positions, with the files that belong beside it. What
/// is to be in metres (`MotionFormat::is_metric`) or of the canonical body is given so. Throws
/// mien::Error if that format is not written, WriteFailure if a file cannot be written.
void write_motion(const Recording& recording, const std::filesystem::path& path);

}  // namespace mien::motion
