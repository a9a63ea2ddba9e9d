#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// Files and folders as they were at a time, by the time of their last change and their size.
class SeenFiles {
 public:
  explicit SeenFiles(const std::vector<std::filesystem::path>& paths);

  /// Whether no file has been replaced, edited, removed or added to a folder since.
  bool are_unchanged() const;

 private:
  struct SeenFile {
    std::filesystem::path path;
    std::filesystem::file_time_type changed;
    std::uintmax_t bytes = 0;  ///< of a folder or a missing file, a number without meaning

    friend bool operator==(const SeenFile&, const SeenFile&) = default;
  };

  static SeenFile seen(const std::filesystem::path& path);

  std::vector<SeenFile> files_;
};

/// Returns the files of the manifest's examples, with their folder, scales and ratings.
std::vector<std::filesystem::path> files_of_examples(const Manifest& manifest);

/// Returns the motion files of a stimulus, and the recipes.
std::vector<std::filesystem::path> files_of_motion(const Manifest& manifest,
                                                   const Stimulus& stimulus);

}  // namespace mien::pipeline
