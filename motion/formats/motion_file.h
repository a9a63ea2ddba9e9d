#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "motion/formats/reading/read_options.h"
#include "motion/points/point_recording.h"
#include "motion/skeleton/recording.h"

namespace mien::motion {

/// What a motion file holds: rotations of joints, or points.
using FileContents = std::variant<Recording, PointRecording>;

/// A format of motion files, recognised by the file extension. The list in motion_file.cpp is the
/// only one: reading, writing, messages and help texts are derived from it. To support another
/// format, add an entry to it.
struct MotionFormat {
  std::string_view ending;  ///< in lower case: ".bvh"
  std::string_view name;    ///< "BVH"; extensions of the same format have the same name
  /// Extension of companion files in the same folder: ".asf"; may be empty.
  std::string_view part_ending = {};
  bool has_takes = false;            ///< a file may contain several motions (takes)
  bool has_subjects = false;         ///< a file may contain several people
  bool is_streamed = false;          ///< frames can be read as they arrive (bvh_stream.h)
  bool is_metric = false;            ///< written in metres with +Y up, whatever the input
  bool has_nameless_points = false;  ///< `ReadOptions::joints` names them
  /// The extension belongs to no other kind of files: tables and the like are read if they are
  /// named, but not taken for motions when a folder is searched.
  bool is_of_motions = true;
  FileContents (*read)(const std::filesystem::path& path, const ReadOptions& options);
  void (*write)(const Recording& recording, const std::filesystem::path& path) = nullptr;
};

/// All formats, one entry per file extension.
std::span<const MotionFormat> motion_formats();

/// The extension of a file name in lower case, without that of a compressed file, as in
/// `MotionFormat::ending`: ".bvh" for "Walk.BVH" and "walk.bvh.gz".
std::string lower_case_ending(const std::filesystem::path& path);

/// The format of a file by its extension, in upper or lower case; null if the extension is unknown.
const MotionFormat* motion_format(const std::filesystem::path& path);

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

/// Writes a motion in the format of the file's extension. Throws mien::Error if that format is not
/// written, WriteFailure if the file cannot be written.
void write_motion(const Recording& recording, const std::filesystem::path& path);

}  // namespace mien::motion
