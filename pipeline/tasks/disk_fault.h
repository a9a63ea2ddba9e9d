#pragma once

#include <exception>
#include <filesystem>
#include <string>

#include "pipeline/base/documents/files.h"

namespace mien::pipeline {

/// The disk is the reason that something was not written: `what()` is disk_fault's.
class DiskFault : public WriteFailure {
 public:
  using WriteFailure::WriteFailure;
};

/// What ails the disk that holds a folder, for people: that it is full, that a quota is used up,
/// that it is read-only, that the folder is not there (any more). Told by the error that something
/// ended with, or else by the disk itself, since libraries that write pictures and videos do not
/// say. Empty when it is none of these. The same words for whatever was being written, so that they
/// need be told once.
std::string disk_fault(const std::filesystem::path& folder, const std::exception& error);

/// The same, of the disk as it is now and without what to do; a folder that is not there is none.
std::string disk_ailment(const std::filesystem::path& folder);

}  // namespace mien::pipeline
