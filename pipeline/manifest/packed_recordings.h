#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace mien::pipeline {

/// Name of the file in a packed study that lists its recordings, beside provenance.json, and of the
/// folder that contains them.
inline constexpr char packed_recordings_path[] = "recordings.json";
inline constexpr char packed_recordings_folder[] = "recordings";

/// The recordings of a packed study, by their names in provenance.json: "captures/walk.bvh".
struct PackedRecordings {
  std::vector<std::string> packed;          ///< in recordings/, under their names
  std::vector<std::string> left_out;        ///< because their licence does not permit sharing
  std::vector<std::string> left_out_files;  ///< motion files made from such recordings, as paths
                                            ///< relative to the study: "clips/walk.bvh"
  /// Folders of recordings as inputs/as-run.yaml names them, and their names in recordings/:
  /// "../../captures" → "captures".
  std::map<std::string, std::string> folders;

  bool empty() const { return packed.empty() && left_out.empty() && left_out_files.empty(); }
};

/// Reads the list in a study's folder; empty if there is none. Throws Error if it is damaged or
/// names a file outside the folder.
PackedRecordings packed_recordings_in(const std::filesystem::path& folder);

/// The list as JSON.
std::string to_json(const PackedRecordings& recordings);

/// Returns the place in the study's folder of the file or folder that inputs/as-run.yaml names by
/// this text, whether or not it exists; empty if its folder is not one of `folders`.
std::filesystem::path packed_place(const PackedRecordings& recordings,
                                   const std::filesystem::path& folder, const std::string& text);

}  // namespace mien::pipeline
