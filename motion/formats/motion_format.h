#pragma once

#include <array>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "motion/formats/motion_file.h"

namespace mien::motion {

/// What is written about a file of points besides the points.
struct PointFile {
  std::string name;                       ///< "walk.csv"; errors name it
  std::string axes = "as in the source";  ///< what its description says of the axes
};

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
  bool is_metric = false;            ///< motions are written in metres with +Y up
  bool is_of_body = false;           ///< written are motions of the canonical body alone
  bool states_unit = false;          ///< points can be written only if their unit is known
  bool has_nameless_points = false;  ///< `ReadOptions::joints` names them
  /// The extension belongs to no other kind of files: tables and the like are read if they are
  /// named, but not taken for motions when a folder is searched.
  bool is_of_motions = true;
  FileContents (*read)(const std::filesystem::path& path, const ReadOptions& options);

  /// The file as it is written from rotations of joints; null if it holds points, or none is
  /// written.
  std::string (*bytes_of_motion)(const Recording& recording) = nullptr;
  /// The file as it is written from points, followed by its companions; null for other formats.
  std::vector<std::string> (*bytes_of_points)(const PointRecording& points,
                                              const PointFile& file) = nullptr;
  /// What a file and the companions that are written with it have after the same beginning: "walk"
  /// is followed by ".csv" and ".csv.json". Of unused ones, the text is empty.
  std::string_view written_ending = ending;
  std::array<std::string_view, 2> companions = {};
  /// Throws mien::Error for a name that the format does not allow; null if any will do.
  void (*require_name)(const std::filesystem::path& file) = nullptr;

  bool is_written() const { return bytes_of_motion != nullptr || holds_points(); }
  bool holds_points() const { return bytes_of_points != nullptr; }  ///< if it is written
  /// Whether it can be chosen for the clips of a manifest, whose names are those of stimuli.
  bool is_of_clips() const { return is_written() && require_name == nullptr; }
};

/// All formats, one entry per file extension.
std::span<const MotionFormat> motion_formats();

/// The format of a file by its extension, in upper or lower case; null if the extension is unknown.
const MotionFormat* motion_format(const std::filesystem::path& path);

}  // namespace mien::motion
