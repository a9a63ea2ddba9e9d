#include "pipeline/production/archive/extra_files.h"

#include <algorithm>
#include <set>
#include <system_error>

#include "pipeline/production/archive/not_kept.h"
#include "pipeline/tasks/stale_artifacts.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

std::set<std::string> known_paths(const StudyContents& contents) {
  std::set<std::string> known = {"provenance.json", not_kept_path, contents.as_run};
  for (const ArtifactRecord& record : contents.artifacts) known.insert(record.path);
  for (const ArtifactRecord& record : contents.inputs) known.insert(record.path);
  // Of no graph at all, everything that has a receipt is stale.
  for (const Receipt& receipt : stale_artifacts(contents.folder, {}, {}))
    known.insert(receipt.path);
  return known;
}

}  // namespace

std::vector<std::string> extra_files(const StudyContents& contents) {
  const std::set<std::string> known = known_paths(contents);
  std::vector<std::string> extra;
  std::error_code unknown;
  for (auto entry = fs::recursive_directory_iterator(contents.folder);
       entry != fs::recursive_directory_iterator(); ++entry) {
    const std::string path = entry->path().lexically_relative(contents.folder).generic_string();
    const bool is_folder = entry->is_directory(unknown) && !entry->is_symlink(unknown);
    if (is_bookkeeping(path) || known.contains(path)) {
      if (is_folder) entry.disable_recursion_pending();
    } else if (!is_folder) {
      extra.push_back(path);
    }
  }
  std::ranges::sort(extra);
  return extra;
}

}  // namespace mien::pipeline
