#pragma once

#include <exception>
#include <filesystem>
#include <string>

#include "pipeline/base/documents/files.h"

namespace mien::pipeline {

/// A write failure caused by the disk; `what()` states the problem and a remedy, as disk_fault
/// does.
class DiskFault : public WriteFailure {
 public:
  using WriteFailure::WriteFailure;
};

/// The problem of the disk that holds a folder, and its remedy: the disk is full (less than 1 MiB,
/// or no file can be added) or read-only, a quota is used up, or the folder does not exist (any
/// more) or cannot be reached. Determined from `error`, or else from the disk itself, since
/// libraries that write images and videos do not report the reason. Empty if the disk has none of
/// these problems. The text does not depend on the file written, so that it can be reported once.
std::string disk_fault(const std::filesystem::path& folder, const std::exception& error);

/// The present problem of the disk that holds a folder, without a remedy: full or read-only. Empty
/// if there is none or the folder does not exist; a used-up quota is not detected.
std::string current_disk_problem(const std::filesystem::path& folder);

}  // namespace mien::pipeline
