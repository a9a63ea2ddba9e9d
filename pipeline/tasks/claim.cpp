#include "pipeline/tasks/claim.h"

#include <cerrno>
#include <fstream>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

#include "pipeline/base/documents/files.h"
#include "pipeline/tasks/hash.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

/// Creates a file exclusively, also on NFS. Returns false if it already exists.
bool create_alone(const fs::path& file) {
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor >= 0) {
    ::close(descriptor);
    return true;
  }
  if (errno == EEXIST) return false;
  throw std::system_error(errno, std::generic_category(), file.string());
}

/// Writes the worker's name into a claim; releases the claim if that fails.
void sign(const fs::path& file, const std::string& worker) {
  try {
    write_file(file, worker + "\n");
  } catch (...) {
    std::error_code ignored;
    fs::remove(file, ignored);
    throw;
  }
}

/// Whether an error means that the file system has no hard links.
bool has_no_links(int error) {
  return error == EPERM || error == EOPNOTSUPP || error == ENOSYS || error == EMLINK;
}

/// Creates a claim that names its worker from the start, unless there already is one: a hard link
/// to a file written before, which only one process can create. On file systems without hard links
/// the claim names no worker for a moment.
bool create_signed(const fs::path& file, const std::string& worker) {
  fs::path own = file;
  own += "." + worker;
  sign(own, worker);
  const int error = ::link(own.c_str(), file.c_str()) == 0 ? 0 : errno;
  std::error_code ignored;
  fs::remove(own, ignored);
  if (error == 0) return true;
  if (error == EEXIST) return false;
  if (!has_no_links(error)) throw std::system_error(error, std::generic_category(), file.string());
  if (!create_alone(file)) return false;
  sign(file, worker);
  return true;
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
  if (!create_signed(file, worker)) {
    // A claim without a name is from a process that was killed at that moment or is about to write
    // its name; in the latter case two processes may do the same work, which is harmless.
    const std::string holder = claim_holder(file);
    if (holder != worker && !holder.empty() && watch.seems_alive(holder)) return nullptr;
    fs::remove_all(file);
    if (!create_signed(file, worker)) return nullptr;
  }
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
