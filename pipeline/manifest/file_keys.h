#pragma once

#include <filesystem>
#include <map>

#include "pipeline/tasks/hash.h"

namespace mien::pipeline {

/// What files stand for in the keys of artifacts: each by its name and content, with the files that
/// belong to it, and not by the folder that it lies in. A file that many stimuli name is read once,
/// when it is first asked for.
class FileKeys {
 public:
  const Hash& of(const std::filesystem::path& file);

  /// The hash of a character's file with the buffers and pictures that it refers to.
  const Hash& of_character(const std::filesystem::path& file);

 private:
  std::map<std::filesystem::path, Hash> files_;
  std::map<std::filesystem::path, Hash> characters_;
};

}  // namespace mien::pipeline
