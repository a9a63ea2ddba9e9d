#pragma once

#include <filesystem>
#include <string>

namespace mien::render {

// Libraries that take long to load are linked to parts of the program (plug-ins): files beside it
// that are loaded when they are first needed.

/// What a part defines as `mien_part`, extern "C": gives its interface, an object that lives as
/// long as the program, or nothing to a program that was built with another edition of the
/// interface.
using PartEntry = const void*(int edition);

/// Loads a part, which is never closed, and gives its interface. `name` is its file's, `purpose`
/// completes "the part of mien that …". Throws Error when it is not there, cannot be loaded or is
/// of another edition.
const void* load_part(const std::string& name, const std::string& purpose, int edition);

/// The version in the name of the file that a library's path leads to, without loading it: "2.4.7"
/// of "libOpenImageIO.so.2.4.7"; empty where the name has none of three numbers.
std::string version_of_library(const std::filesystem::path& library);

}  // namespace mien::render
