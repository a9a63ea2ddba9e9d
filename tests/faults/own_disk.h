#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>

#include "faults/trial.h"

namespace mien::test {

/// A small disk in memory. In a separate mount namespace, only this process and its children see
/// it.
class OwnDisk {
 public:
  /// Mounts it on a folder, with space for `bytes` bytes and, unless 0, for `files` files.
  OwnDisk(std::filesystem::path folder, std::size_t bytes, int files = 0);
  ~OwnDisk();
  OwnDisk(const OwnDisk&) = delete;
  OwnDisk& operator=(const OwnDisk&) = delete;

  /// Returns false if its content is larger already.
  bool resize(std::size_t bytes, int files = 0);
  /// Returns false while a file is open for writing.
  bool set_read_only(bool is_read_only);

 private:
  std::filesystem::path folder_;
};

/// Calls `work` in a child process with its own mount namespace and takes over its figures. If that
/// is not possible, `skipped` states why.
void with_own_mounts(Figures& figures, const std::function<void(Figures&)>& work);

}  // namespace mien::test
