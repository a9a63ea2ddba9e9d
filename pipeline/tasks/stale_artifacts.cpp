#include "pipeline/tasks/stale_artifacts.h"

#include <algorithm>
#include <set>
#include <string_view>
#include <system_error>

#include "motion/text/safe_name.h"
#include "pipeline/base/documents/files.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

std::set<std::string> paths_of(const TaskGraph& graph) {
  std::set<std::string> paths;
  for (const Task& task : graph.tasks) {
    for (const Product& product : task.products) paths.insert(product.path);
  }
  return paths;
}

/// Folders from `folder` up to the store's own, while they are empty.
void remove_empty(fs::path folder, const fs::path& store) {
  std::error_code ignored;
  while (folder != store && fs::is_empty(folder, ignored) && fs::remove(folder, ignored))
    folder = folder.parent_path();
}

}  // namespace

std::vector<Receipt> stale_artifacts(const fs::path& folder, const TaskGraph& graph,
                                     const std::vector<std::string>& kept) {
  const fs::path receipts = folder / ".mien" / "receipts";
  std::vector<Receipt> stale;
  if (!fs::is_directory(receipts)) return stale;
  constexpr std::string_view extension = ".json";
  std::set<std::string> made = paths_of(graph);
  made.insert(kept.begin(), kept.end());
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(receipts)) {
    if (!entry.is_regular_file()) continue;
    const std::string path = entry.path().lexically_relative(receipts).generic_string();
    if (made.contains(path.substr(0, path.size() - extension.size()))) continue;
    const std::optional<Receipt> receipt = receipt_from_json(read_file(entry.path()));
    // A receipt whose path does not match its location was not written by mien.
    if (receipt && receipt_path(folder, receipt->path) == entry.path()) stale.push_back(*receipt);
  }
  std::ranges::sort(stale, {}, &Receipt::path);
  return stale;
}

std::vector<std::string> shown_paths(const std::vector<Receipt>& artifacts) {
  std::vector<std::string> paths;
  for (const Receipt& artifact : artifacts) {
    if (!artifact.path.starts_with(".mien/")) paths.push_back(artifact.path);
  }
  return paths;
}

bool is_removable(const fs::path& folder, const Receipt& artifact) {
  if (!motion::is_inside(folder, artifact.path)) return false;
  return !fs::exists(folder / artifact.path) ||
         find_artifact(folder, artifact.path, artifact.key).has_value();
}

bool remove_artifact(const Store& store, const Receipt& artifact) {
  const fs::path& folder = store.folder();
  const fs::path target = folder / artifact.path;
  if (!is_removable(folder, artifact)) return false;
  for (const FrameReceipt& frame : artifact.frames) fs::remove(target / frame.name);
  if (artifact.frames.empty()) {
    fs::remove(target);
    remove_empty(target.parent_path(), folder);
  } else {
    remove_empty(target, folder);
  }
  const fs::path receipt = receipt_path(folder, artifact.path);
  fs::remove(receipt);
  remove_empty(receipt.parent_path(), folder);
  return true;
}

}  // namespace mien::pipeline
