#include "pipeline/tasks/claim.h"

#include <cerrno>
#include <fstream>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

#include "pipeline/documents/files.h"
#include "pipeline/tasks/hash.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

/// False when the file is there already. Who creates it alone is known on NFS, too.
bool create_alone(const fs::path& file) {
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor >= 0) {
    ::close(descriptor);
    return true;
  }
  if (errno == EEXIST) return false;
  throw std::system_error(errno, std::generic_category(), file.string());
}

/// A claim without a signature is given back.
void sign(const fs::path& file, const std::string& worker) {
  try {
    write_file(file, worker + "\n");
  } catch (...) {
    std::error_code ignored;
    fs::remove(file, ignored);
    throw;
  }
}

}  // namespace

Claim::Claim(fs::path file, std::string worker)
    : file_(std::move(file)), worker_(std::move(worker)) {}

Claim::~Claim() {
  std::error_code ignored;
  if (claim_holder(file_) == worker_) fs::remove(file_, ignored);
}

std::unique_ptr<Claim> Claim::take(const fs::path& folder, const std::string& what,
                                   const std::string& worker, WorkerWatch& watch) {
  const fs::path claims = folder / ".mien" / "claims";
  make_folder(claims);
  const fs::path file = claims / hash_of(what);
  if (!create_alone(file)) {
    // One that nobody has signed was left by a process that was killed at that moment, or will be
    // signed in the next one: then two make the same, which harms nothing.
    const std::string holder = claim_holder(file);
    if (holder != worker && !holder.empty() && watch.seems_alive(holder)) return nullptr;
    fs::remove_all(file);
    if (!create_alone(file)) return nullptr;
  }
  sign(file, worker);
  return std::unique_ptr<Claim>(new Claim(file, worker));
}

std::string claim_holder(const fs::path& file) {
  std::error_code none;
  if (!fs::is_regular_file(file, none)) return "";
  std::ifstream stream(file);
  std::string name;
  std::getline(stream, name);
  return name;
}

}  // namespace mien::pipeline
