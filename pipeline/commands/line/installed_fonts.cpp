#include "pipeline/commands/line/installed_fonts.h"

#include <cstdlib>
#include <system_error>

namespace mien::pipeline {

namespace fs = std::filesystem;

fs::path fonts_beside(const fs::path& program) {
  const fs::path file = program.parent_path().parent_path() / "share/mien/fonts/fonts.conf";
  std::error_code unknown;
  return fs::is_regular_file(file, unknown) ? file : fs::path();
}

void use_installed_fonts() {
  std::error_code unknown;
  const fs::path fonts = fonts_beside(fs::read_symlink("/proc/self/exe", unknown));
  if (!fonts.empty()) ::setenv("FONTCONFIG_FILE", fonts.c_str(), 0);
}

}  // namespace mien::pipeline
