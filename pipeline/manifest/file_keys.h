#pragma once

#include <filesystem>
#include <map>

#include "pipeline/tasks/hash.h"

namespace mien::pipeline {

/// Hashes of files for the keys of artifacts. A hash covers the file's name, its content and the
/// files that belong to it, but not its folder. Each file is read once, when its hash is first
/// requested.
class FileKeys {
 public:
  const Hash& of(const std::filesystem::path& file);

  /// Returns the hash of a character's file including the buffers and images that it refers to.
  const Hash& of_character(const std::filesystem::path& file);

 private:
  std::map<std::filesystem::path, Hash> files_;
  std::map<std::filesystem::path, Hash> characters_;
};

}  // namespace mien::pipeline
