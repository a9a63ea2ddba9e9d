#pragma once

#include <filesystem>

namespace mien::pipeline {

/// The configuration of the fonts that were installed with a program: share/mien/fonts/fonts.conf
/// beside the program's folder, as in the archive of `./mien tarball`. Empty if there is none.
std::filesystem::path fonts_beside(const std::filesystem::path& program);

/// Makes fontconfig use the fonts that were installed with this program, if there are any and the
/// environment variable FONTCONFIG_FILE is not set, also in programs that this one starts. To be
/// called before other threads run, because it changes the environment.
void use_installed_fonts();

}  // namespace mien::pipeline
