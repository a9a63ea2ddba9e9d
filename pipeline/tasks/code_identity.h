#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace mien::pipeline {

/// Hashes of the source files that affect each kind of artifact, so that artifacts are produced
/// again after their code has changed. A hash depends only on the contents of these files and on
/// their paths in the source tree (code_identity.cmake).
std::string_view motion_code();
std::string_view film_code();   ///< films: their frames, videos and tables
std::string_view sheet_code();  ///< comparison sheets, galleries and stills
std::string_view study_code();  ///< a study as a whole, including its tables and pages

/// "0.2.0"
std::string_view program_version();

/// Release date of this version in CHANGELOG.md: "2026-11-22".
std::string_view release_date();

/// Compiler and libraries by name, in fixed order: {"Eigen", "3.4.0"}, …
std::vector<std::pair<std::string, std::string>> library_versions();

}  // namespace mien::pipeline
