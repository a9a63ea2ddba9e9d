#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>

#include "faults/trial.h"

namespace mien::test {

/// A small disk in memory. Where this process has mounts of its own, only it and those that it
/// starts can see it.
class OwnDisk {
 public:
  /// Mounts it on a folder, with room for so many bytes, and for so many files unless that is 0.
  OwnDisk(std::filesystem::path folder, std::size_t bytes, int files = 0);
  ~OwnDisk();
  OwnDisk(const OwnDisk&) = delete;
  OwnDisk& operator=(const OwnDisk&) = delete;

  /// False when it holds more already.
  bool resize(std::size_t bytes, int files = 0);
  /// False while a file is open for writing.
  bool set_read_only(bool is_read_only);

 private:
  std::filesystem::path folder_;
};

/// Calls `work` in a process of its own that has mounts of its own, and takes over the figures that
/// it leaves. Where that is not possible, `skipped` says why.
void with_own_mounts(Figures& figures, const std::function<void(Figures&)>& work);

}  // namespace mien::test
