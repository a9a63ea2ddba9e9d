#pragma once

#include <string>

namespace mien::pipeline {

/// Return the versions of Cairo and Pango, which draw pages, as "1.16.0". The libraries are loaded
/// only if the names of their files do not state the version; if that fails, throw render::Error.
std::string cairo_library();
std::string pango_library();

/// The release of Cairo, or Pango, for the version in the name of its library file: "1.16.0" for
/// Cairo's "2.11600.0", "1.50.12" for Pango's "0.5000.12"; empty for other forms.
std::string cairo_release(const std::string& file_version);
std::string pango_release(const std::string& file_version);

}  // namespace mien::pipeline
