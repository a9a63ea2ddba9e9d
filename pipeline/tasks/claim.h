#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "pipeline/tasks/worker_presence.h"

namespace mien::pipeline {

/// Word to the other processes in a study's folder that something is being made here, so that they
/// make something else in the meantime. Nothing but time depends on it: what is made twice is
/// published once. Given back when the object ends.
class Claim {
 public:
  /// Nothing while another process that seems to live has it; of one that does not, it is taken
  /// over. Throws std::system_error or WriteFailure when the folder cannot be written to.
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

/// Who has signed a claim; empty when nobody has.
std::string claim_holder(const std::filesystem::path& file);

}  // namespace mien::pipeline
