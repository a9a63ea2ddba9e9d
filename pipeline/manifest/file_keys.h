#pragma once

#include <filesystem>
#include <map>

#include "pipeline/tasks/hash.h"

namespace mien::pipeline {

/// Hashes of files for the keys of artifacts. A hash covers the names and contents of the file and
/// of its companion files (motion_parts), but not its folder. The hash of each file is determined
/// once, when it is first requested.
class FileKeys {
 public:
  const Hash& of(const std::filesystem::path& file);

  /// Sets the hash of a file of which only part counts: `content` is the hash of that part.
  void set(const std::filesystem::path& file, const Hash& content);

  /// Returns the hash of a character's file including the buffers and images that it refers to.
  const Hash& of_character(const std::filesystem::path& file);

 private:
  std::map<std::filesystem::path, Hash> files_;
  std::map<std::filesystem::path, Hash> characters_;
};

}  // namespace mien::pipeline
