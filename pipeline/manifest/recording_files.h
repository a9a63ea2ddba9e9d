#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/base/documents/fault.h"
#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// A motion file that a manifest names, directly or as one of a folder of examples.
struct RecordingFile {
  std::filesystem::path file;
  std::vector<std::filesystem::path> parts;  ///< companion files (motion_parts)
  Licence licence;
  std::string source;  ///< where it can be obtained; empty: not stated
  std::string path;    ///< path in the manifest of what is stated, otherwise of the first mention
  bool is_example = false;  ///< whether it is one of the folder of examples
};

/// Returns the motion files of the examples and of all stimuli, each once, sorted by path. A
/// licence or source that is stated in one place holds wherever the file is named. Throws Error if
/// the examples' folder cannot be read.
std::vector<RecordingFile> recording_files(const Manifest& manifest);

/// Returns a fault for each licence and source of a file that differs from another one stated for
/// the same file, and for each that is stated for a pose of an example. Files are not read.
std::vector<Fault> check_licences(const Manifest& manifest);

/// Whether a modification of the stimulus uses an example.
bool names_examples(const Stimulus& stimulus);

/// Returns the names of the licences, sorted, that do not permit sharing the motion of a stimulus:
/// those of its clip, of the motions of its path, of poses of its modifications and, if it uses
/// examples, of their folder. A motion made from a recording still carries the recorded movement.
/// `recordings` are those of the manifest (recording_files).
std::vector<std::string> restricting_licences(const Stimulus& stimulus,
                                              const std::vector<RecordingFile>& recordings);

}  // namespace mien::pipeline
