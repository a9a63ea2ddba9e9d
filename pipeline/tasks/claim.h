#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "pipeline/tasks/worker_heartbeat.h"

namespace mien::pipeline {

/// Announces to the other processes in a study's folder that this one works on a task, so that they
/// work on other tasks in the meantime. Claims only save time: an artifact that is produced twice
/// is published once. Released by the destructor.
class Claim {
 public:
  /// Claims `what` for `worker`. Returns null while another process that seems alive holds the
  /// claim; a claim of a dead process, or one that names no process, is taken over. Throws
  /// std::system_error or WriteFailure if the folder is not writable.
  static std::unique_ptr<Claim> take(const std::filesystem::path& folder, const std::string& what,
                                     const std::string& worker, WorkerWatch& watch);
  ~Claim();
  Claim(const Claim&) = delete;
  Claim& operator=(const Claim&) = delete;

 private:
  Claim(std::filesystem::path file, std::string worker);

  std::filesystem::path file_;
  std::string worker_;
};

/// Name of the worker that holds a claim; empty if the file names none.
std::string claim_holder(const std::filesystem::path& file);

}  // namespace mien::pipeline
