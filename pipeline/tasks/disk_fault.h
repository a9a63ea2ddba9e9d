#pragma once

#include <exception>
#include <filesystem>
#include <string>

namespace mien::pipeline {

/// What ails the disk that holds a folder, for people: that it is full, that a quota is used up,
/// that it is read-only. Told by the error that something ended with, or else by the disk itself,
/// since libraries that write pictures and videos do not say. Empty when it is none of these. The
/// same words for whatever was being written, so that they need be told once.
std::string disk_fault(const std::filesystem::path& folder, const std::exception& error);

}  // namespace mien::pipeline
