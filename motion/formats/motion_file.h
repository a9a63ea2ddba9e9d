#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "motion/skeleton/recording.h"

namespace mien::motion {

/// A format of motion files, recognised by the ending of a file's name. The list in motion_file.cpp
/// is the only one: reading, writing, messages and help texts are derived from it. To support
/// another format, add an entry there.
struct MotionFormat {
  std::string_view ending;  ///< in lower case: ".bvh"
  std::string_view name;    ///< "BVH"; endings of one format have the same
  std::string_view part_ending =
      {};                    ///< of files beside it that it refers to: ".asf"; may be empty
  bool has_takes = false;    ///< a file may hold several motions to choose a take from
  bool is_streamed = false;  ///< frames can be read as they arrive (bvh_stream.h)
  bool is_metric = false;    ///< written in metres with +Y up, whatever the input
  Recording (*read)(const std::filesystem::path& path, const std::optional<std::string>& take);
  void (*write)(const Recording& recording, const std::filesystem::path& path) = nullptr;
};

/// All of them, one for each ending.
std::span<const MotionFormat> motion_formats();

/// The ending of a file's name in lower case, as formats have it: ".bvh" of "Walk.BVH".
std::string lower_case_ending(const std::filesystem::path& path);

/// The format of a file by the ending of its name, in upper or lower case; null where it is none.
const MotionFormat* motion_format(const std::filesystem::path& path);

/// Those that are read, are written, or may hold several motions, in words: "BVH (.bvh), Acclaim
/// (.amc) or glTF (.gltf, .glb)".
std::string formats_read();
std::string formats_written();
std::string formats_with_takes();

/// Whether `read_motion` supports a file's extension.
bool is_motion_file(const std::filesystem::path& path);

/// Reads a motion by its file's extension. Throws mien::Error: no such file, another extension, or
/// what the reader of the format finds wrong. `take` chooses a motion of a file that holds several;
/// formats of single motions refuse it.
Recording read_motion(const std::filesystem::path& path,
                      const std::optional<std::string>& take = std::nullopt);

/// As `read_motion`, where an empty `take` means the first of several motions.
Recording read_take(const std::filesystem::path& path, const std::string& take);

/// Whether a file of this extension may hold several motions to choose a take from.
bool may_hold_takes(const std::filesystem::path& path);

/// Writes a motion by its file's extension. Throws mien::Error.
void write_motion(const Recording& recording, const std::filesystem::path& path);

}  // namespace mien::motion
