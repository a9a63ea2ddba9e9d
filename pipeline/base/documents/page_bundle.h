#pragma once

#include <filesystem>
#include <string>

namespace mien::pipeline {

/// The folder of a page ("questionnaire"), as page/build.mjs bundles it: ../share/mien/pages/<name>
/// beside an installed program, pages/<name> beside one that was built. Empty when there is
/// neither.
std::filesystem::path page_beside(const std::filesystem::path& program, const std::string& name);

/// That folder for the program that is running. Throws Error, with how to build it, when it is not
/// there.
std::filesystem::path page_bundle(const std::string& name);

}  // namespace mien::pipeline
