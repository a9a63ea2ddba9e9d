#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>

namespace mien::pipeline {

/// How the last attempt at an element ended, when it did not end well.
struct ElementEnd {
  int code = 0;                ///< of the worker, or 128 + the signal that ended it
  int restarts = 0;            ///< how often Slurm had begun it anew before
  bool lacked_memory = false;  ///< the job's control group counts a kill for want of memory
};

/// What jobs of a submission left in ends/, by job ("2-frames") and element, from 1. `submission`:
/// its folder, out/<study>/farm/0001. A file that says nothing is left out.
std::map<std::pair<std::string, int>, ElementEnd> ends_in(const std::filesystem::path& submission);

}  // namespace mien::pipeline
