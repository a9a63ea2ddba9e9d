#pragma once

#include <filesystem>

namespace mien::pipeline {

/// A new folder in the system's temporary directory, removed with the object.
class ScratchFolder {
 public:
  /// Throws std::system_error if the folder cannot be created.
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace mien::pipeline
