#pragma once

#include <string>

namespace mien::pipeline {

/// Versions of the libraries that draw pages, "1.16.0", without loading them.
std::string cairo_library();
std::string pango_library();

/// "1.16.0" of "2.11600.0", the version in the name of Cairo's file, and "1.50.12" of "0.5000.12",
/// that of Pango's; empty for what is none of theirs.
std::string cairo_release(const std::string& file_version);
std::string pango_release(const std::string& file_version);

}  // namespace mien::pipeline
