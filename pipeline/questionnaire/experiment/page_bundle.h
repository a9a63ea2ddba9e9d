#pragma once

#include <filesystem>

namespace mien::pipeline {

/// The folder of the pages that participants see, as questionnaire/page/build.mjs bundles them:
/// ../share/mien/pages/questionnaire beside an installed program, pages/questionnaire beside one
/// that was built. Empty when there is neither.
std::filesystem::path pages_beside(const std::filesystem::path& program);

/// That folder for the program that is running. Throws Error, with how to build them, when they
/// are not there.
std::filesystem::path page_bundle();

}  // namespace mien::pipeline
