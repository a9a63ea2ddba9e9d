#include "pipeline/questionnaire/experiment/page_bundle.h"

#include <system_error>

#include "motion/error.h"

namespace mien::pipeline {

namespace fs = std::filesystem;

fs::path pages_beside(const fs::path& program) {
  const fs::path folder = program.parent_path();
  std::error_code unknown;
  for (const fs::path& pages :
       {folder.parent_path() / "share/mien/pages/questionnaire", folder / "pages/questionnaire"}) {
    if (fs::is_regular_file(pages / "questionnaire.js", unknown)) return pages;
  }
  return {};
}

fs::path page_bundle() {
  std::error_code unknown;
  const fs::path pages = pages_beside(fs::read_symlink("/proc/self/exe", unknown));
  if (!pages.empty()) return pages;
  throw Error("the pages that participants see are not built",
              "start with ./mien in the sources, which brings Node.js and builds them; an "
              "installed mien has them if they were built before its package was");
}

}  // namespace mien::pipeline
