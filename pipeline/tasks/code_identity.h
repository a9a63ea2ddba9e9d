#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace mien::pipeline {

/// Hashes of the source files that can make an artifact, so that what other code made is made
/// again. They depend on these files' contents alone (code_identity.cmake).
std::string_view motion_code();
std::string_view film_code();   ///< frames, videos and what is found for and of them
std::string_view sheet_code();  ///< comparison sheets and stills
std::string_view study_code();  ///< all of a study, its tables and pages too

/// "0.2.0"
std::string_view program_version();

/// The day of this version in CHANGELOG.md: "2026-11-22".
std::string_view release_date();

/// Compiler and libraries by name, in fixed order: {"Eigen", "3.4.0"}, …
std::vector<std::pair<std::string, std::string>> library_versions();

}  // namespace mien::pipeline
