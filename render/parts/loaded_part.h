#pragma once

#include <filesystem>
#include <string>

namespace mien::render {

// Libraries that take long to load lie behind parts of the program of their own, files beside it
// that are loaded when what they do is first asked for.

/// Loads a part: dlopen's handle, which is never closed. `name` is its file's, `purpose` completes
/// "the part of mien that …". Throws Error when it is not there or cannot be loaded.
void* loaded_part(const std::string& name, const std::string& purpose);

/// A function of a part or of the libraries that it brings. Throws Error when there is none.
void* function_of_part(void* part, const char* function, const std::string& name,
                       const std::string& purpose);

/// Throws Error: the part cannot be loaded, and why.
[[noreturn]] void fail_to_load(const std::string& name, const std::string& purpose,
                               const std::string& why);

/// The version in the name of the file that a library's path leads to, without loading it: "2.4.7"
/// of "libOpenImageIO.so.2.4.7"; empty where the name has none of three numbers.
std::string version_of_library(const std::filesystem::path& library);

}  // namespace mien::render
