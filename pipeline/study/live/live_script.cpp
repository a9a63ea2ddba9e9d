#include "pipeline/study/live/live_script.h"

#include <system_error>

#include <fmt/format.h>

#include "motion/error.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/base/documents/html.h"

namespace mien::pipeline {

namespace fs = std::filesystem;

fs::path live_module_beside(const fs::path& program) {
  const fs::path folder = program.parent_path();
  std::error_code unknown;
  for (const fs::path& pages : {folder.parent_path() / "share/mien/pages", folder / "pages"}) {
    fs::path module = pages / "live_core/live_core.wasm";
    if (fs::is_regular_file(module, unknown)) return module;
  }
  return {};
}

fs::path live_module() {
  std::error_code unknown;
  fs::path module = live_module_beside(fs::read_symlink("/proc/self/exe", unknown));
  if (!module.empty()) return module;
  throw Error("the motion core has not been compiled for browsers",
              "run ./mien in the source tree, which installs Emscripten and compiles it; an "
              "installed mien has it if its package was built with it");
}

std::string live_script(const fs::path& module, const motion::LiveBundle& bundle) {
  return fmt::format("globalThis.mien_live_files = {{\n  module: \"{}\",\n  bundle: \"{}\",\n}};\n",
                     in_base64(read_file(module)), in_base64(motion::to_bytes(bundle)));
}

}  // namespace mien::pipeline
