#pragma once

#include <filesystem>
#include <string>

namespace mien::render {

// Libraries that take long to load are linked to parts of the program (plug-ins): separate files
// that are loaded when they are first needed.

/// The type of the extern "C" function `mien_part` that each part defines. It returns the part's
/// interface, an object that lives as long as the program, or null if the program was built with
/// another edition of the interface.
using PartEntry = const void*(int edition);

/// Loads a part, which is never unloaded, and returns its interface. `name` is its file name;
/// `purpose` completes "the part of mien that …" in messages. Throws Error when the file is
/// missing, cannot be loaded or has another edition.
const void* load_part(const std::string& name, const std::string& purpose, int edition);

/// Returns the version in a library's file name, with symbolic links resolved, without loading it:
/// "2.4.7" for "libOpenImageIO.so.2.4.7"; empty if the name has no version of three numbers.
std::string version_of_library(const std::filesystem::path& library);

}  // namespace mien::render
