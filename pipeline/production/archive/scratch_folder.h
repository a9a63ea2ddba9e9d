#pragma once

#include <filesystem>

namespace mien::pipeline {

/// A fresh folder among the machine's temporary files, removed with the object.
class ScratchFolder {
 public:
  /// Throws std::system_error when there can be none.
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace mien::pipeline
