#pragma once

#include <exception>
#include <filesystem>
#include <string>

#include "pipeline/base/documents/files.h"

namespace mien::pipeline {

/// A write failure caused by the disk; `what()` is the text of disk_fault.
class DiskFault : public WriteFailure {
 public:
  using WriteFailure::WriteFailure;
};

/// The problem of the disk that holds a folder, and its remedy: the disk is full or read-only, a
/// quota is used up, or the folder does not exist (any more). Determined from `error`, or else from
/// the disk itself, since libraries that write images and videos do not report the reason. Empty if
/// it is none of these. The text does not depend on the file written, so that it can be reported
/// once.
std::string disk_fault(const std::filesystem::path& folder, const std::exception& error);

/// The present problem of the disk that holds a folder, without a remedy; empty if there is none or
/// the folder does not exist.
std::string current_disk_problem(const std::filesystem::path& folder);

}  // namespace mien::pipeline
