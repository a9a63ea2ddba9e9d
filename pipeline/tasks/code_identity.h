#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace mien::pipeline {

/// Hashes of the source files that this program was built from, so that artifacts made by other
/// code are made again. They depend on the files' contents alone.
std::string_view motion_code();
std::string_view film_code();  ///< render, scenes and the making of frames and videos
std::string_view pipeline_code();

/// "0.2.0"
std::string_view program_version();

/// The day of this version in CHANGELOG.md: "2026-11-22".
std::string_view release_date();

/// Compiler and libraries by name, in fixed order: {"Eigen", "3.4.0"}, …
std::vector<std::pair<std::string, std::string>> library_versions();

}  // namespace mien::pipeline
