#pragma once

#include <cstdlib>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include "pipeline/temporary_folder.h"

namespace mien::test {

/// A folder with the common set-up of several tests, to be copied, not changed. `make` fills it on
/// first use: once per program or, if MIEN_SHARED_SET_UP names a folder, once for all programs that
/// use it. `./mien test` provides a fresh one for each run.
inline std::filesystem::path shared_set_up(
    const std::string& name, const std::function<void(const std::filesystem::path&)>& make) {
  namespace fs = std::filesystem;
  static std::map<std::string, std::unique_ptr<TemporaryFolder>> own;
  const char* shared = std::getenv("MIEN_SHARED_SET_UP");
  if (shared == nullptr) {
    auto& folder = own[name];
    if (folder == nullptr) {
      auto fresh = std::make_unique<TemporaryFolder>();
      make(fresh->path());
      folder = std::move(fresh);
    }
    return folder->path();
  }
  const fs::path folder = fs::path(shared) / name, done = folder / "done", made = folder / "made";
  fs::create_directories(folder);
  // Whoever comes first makes it, the others wait; a lock ends with its process.
  const int lock = ::open((folder / "lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  ::flock(lock, LOCK_EX);
  try {
    if (!fs::exists(done)) {
      fs::remove_all(made);
      fs::create_directory(made);
      make(made);
      fs::create_directory(done);
    }
  } catch (...) {
    ::close(lock);
    throw;
  }
  ::close(lock);
  return made;
}

}  // namespace mien::test
