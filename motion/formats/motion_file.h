#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "motion/skeleton/recording.h"

namespace mien::motion {

/// A format of motion files, recognised by the file extension. The list in motion_file.cpp is the
/// only one: reading, writing, messages and help texts are derived from it. To support another
/// format, add an entry to it.
struct MotionFormat {
  std::string_view ending;  ///< in lower case: ".bvh"
  std::string_view name;    ///< "BVH"; extensions of the same format have the same name
  /// Extension of companion files in the same folder: ".asf"; may be empty.
  std::string_view part_ending = {};
  bool has_takes = false;    ///< a file may contain several motions (takes)
  bool is_streamed = false;  ///< frames can be read as they arrive (bvh_stream.h)
  bool is_metric = false;    ///< written in metres with +Y up, whatever the input
  Recording (*read)(const std::filesystem::path& path, const std::optional<std::string>& take);
  void (*write)(const Recording& recording, const std::filesystem::path& path) = nullptr;
};

/// All formats, one entry per file extension.
std::span<const MotionFormat> motion_formats();

/// The extension of a file name in lower case, as in `MotionFormat::ending`: ".bvh" for "Walk.BVH".
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

/// Reads a motion in the format of the file's extension. Throws mien::Error if the file does not
/// exist, its extension is not supported, or the reader of the format finds a fault. `take` selects
/// a motion in a file with several; formats with single motions refuse it.
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
