#pragma once

#include <filesystem>
#include <string>

namespace mien::pipeline {

/// The folder of a page ("questionnaire") bundled by page/build.mjs: ../share/mien/pages/<name>
/// relative to the folder of an installed program, or pages/<name> in the folder of a program that
/// was built but not installed. Empty if neither exists.
std::filesystem::path page_beside(const std::filesystem::path& program, const std::string& name);

/// The bundle's folder for the running program. If it does not exist, throws Error, which states
/// how to build it.
std::filesystem::path page_bundle(const std::string& name);

}  // namespace mien::pipeline
