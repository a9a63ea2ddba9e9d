#include "pipeline/production/archive/keep.h"

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <system_error>

#include <nlohmann/json.hpp>

#include "motion/error.h"
#include "motion/text/file_contents.h"
#include "motion/text/json_depth.h"
#include "motion/text/safe_name.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/tasks/stale_artifacts.h"
#include "pipeline/tasks/store.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

std::string note_text(const std::map<std::string, ArtifactRecord>& removed) {
  ordered_json files = ordered_json::object();
  for (const auto& [path, record] : removed) {
    files[path] = {{"hash", record.hash}, {"size", record.size}};
    if (record.frames > 0) files[path]["frames"] = record.frames;
  }
  const ordered_json note = {{"about",
                              "removed intentionally by mien clean; links to it in report.html are "
                              "broken until mien run makes it again"},
                             {"not_kept", files}};
  return note.dump(2) + "\n";
}

std::optional<ArtifactKind> kind_of(const std::string& path) {
  const std::string first = path.substr(0, path.find('/'));
  for (const ArtifactKindName& one : artifact_kinds) {
    if (one.name == first) return one.kind;
  }
  return std::nullopt;
}

bool is_there(const fs::path& path) {
  std::error_code unknown;
  return fs::exists(fs::symlink_status(path, unknown));
}

std::vector<ArtifactRecord> records_of(const std::vector<Receipt>& artifacts) {
  std::vector<ArtifactRecord> records;
  for (const Receipt& artifact : artifacts)
    records.push_back(
        {artifact.path, artifact.hash, artifact.size, static_cast<int>(artifact.frames.size())});
  return records;
}

/// Values of an attribute, `href="` say, in a page.
template <class Call>
void each_value(std::string_view page, std::string_view attribute, const Call& call) {
  for (std::size_t at = page.find(attribute); at != std::string_view::npos;
       at = page.find(attribute, at)) {
    at += attribute.size();
    const std::size_t end = page.find('"', at);
    if (end == std::string_view::npos) return;
    call(page.substr(at, end - at));
    at = end;
  }
}

}  // namespace

int dead_links(const fs::path& folder, const Cleaning& cleaning) {
  const motion::FileReading page =
      motion::bytes_of_file(folder / "report.html", motion::max_table_bytes);
  if (!page.bytes) return 0;
  std::set<std::string, std::less<>> gone;
  for (const Receipt& artifact : cleaning.removed) gone.insert(artifact.path);
  int links = 0;
  const auto count = [&](std::string_view target) {
    const std::size_t last = target.rfind('/');
    const bool is_frame = last != std::string_view::npos && gone.contains(target.substr(0, last));
    links += is_frame || gone.contains(target) ? 1 : 0;
  };
  for (const char* attribute : {"href=\"", "src=\"", "poster=\""})
    each_value(*page.bytes, attribute, count);
  return links;
}

Cleaning all_but(const fs::path& folder, const std::vector<ArtifactKind>& kept) {
  if (!is_there(folder)) {
    throw Error({folder.string()}, "there is no such study",
                "name a manifest that was run, or the folder of its study");
  }
  if (!is_there(folder / ".mien" / "receipts")) {
    throw Error({folder.string()}, "has no receipts of what mien made (.mien/receipts)",
                "clean a study where it was made; clean copies by hand");
  }
  Cleaning cleaning;
  for (Receipt& artifact : stale_artifacts(folder, {}, {})) {
    const std::optional<ArtifactKind> kind = kind_of(artifact.path);
    if (!kind || std::ranges::find(kept, *kind) != kept.end()) continue;
    if (!is_there(folder / artifact.path)) continue;
    if (is_removable(folder, artifact)) {
      cleaning.bytes += artifact.size;
      cleaning.removed.push_back(std::move(artifact));
    } else {
      cleaning.changed.push_back(std::move(artifact));
    }
  }
  return cleaning;
}

Cleaning remove_all_but(const fs::path& folder, const std::vector<ArtifactKind>& kept) {
  Cleaning planned = all_but(folder, kept);
  if (planned.removed.empty()) return planned;
  // Noted before it is removed: what is noted and still there is no fault.
  note_not_kept(folder, records_of(planned.removed));
  const Store store(folder, Sharing::exclusive);
  Cleaning cleaning;
  cleaning.changed = std::move(planned.changed);
  for (Receipt& artifact : planned.removed) {
    if (remove_artifact(store, artifact)) {
      cleaning.bytes += artifact.size;
      cleaning.removed.push_back(std::move(artifact));
    } else {
      cleaning.changed.push_back(std::move(artifact));
    }
  }
  return cleaning;
}

std::vector<ArtifactRecord> not_kept_in(const fs::path& folder) {
  std::vector<ArtifactRecord> records;
  const fs::path file = folder / not_kept_path;
  std::error_code unknown;
  if (!fs::exists(fs::symlink_status(file, unknown))) return records;
  const motion::FileReading text = motion::bytes_of_file(file, motion::max_table_bytes);
  try {
    if (!text.bytes) throw Error({file.string()}, text.error, "restore the file");
    const bool is_deep = motion::is_nested_deeper(*text.bytes, motion::max_json_depth);
    const auto note = nlohmann::json::parse(is_deep ? std::string() : *text.bytes);
    for (const auto& [path, entry] : note.at("not_kept").items())
      records.push_back({motion::safe_names(path, {file.string()}), entry.at("hash"),
                         entry.at("size"), entry.value("frames", 0)});
  } catch (const nlohmann::json::exception&) {
    throw Error({file.string()}, "this is not a record of removed files",
                "remove it; the files it recorded then count as missing");
  }
  return records;
}

void note_not_kept(const fs::path& folder, const std::vector<ArtifactRecord>& removed) {
  std::map<std::string, ArtifactRecord> all;
  for (const ArtifactRecord& record : not_kept_in(folder)) all[record.path] = record;
  for (const ArtifactRecord& record : removed) all[record.path] = record;
  write_file(folder / not_kept_path, note_text(all));
}

}  // namespace mien::pipeline
