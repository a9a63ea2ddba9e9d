#include "pipeline/base/documents/page_bundle.h"

#include <system_error>

#include "motion/error.h"

namespace mien::pipeline {

namespace fs = std::filesystem;

fs::path page_beside(const fs::path& program, const std::string& name) {
  const fs::path folder = program.parent_path();
  std::error_code unknown;
  for (const fs::path& pages : {folder.parent_path() / "share/mien/pages", folder / "pages"})
    if (fs::is_regular_file(pages / name / (name + ".js"), unknown)) return pages / name;
  return {};
}

fs::path page_bundle(const std::string& name) {
  std::error_code unknown;
  const fs::path page = page_beside(fs::read_symlink("/proc/self/exe", unknown), name);
  if (!page.empty()) return page;
  throw Error("the web pages are not built",
              "run ./mien in the source tree, which installs Node.js and builds them; an installed "
              "mien has them if its package was built with them");
}

}  // namespace mien::pipeline
