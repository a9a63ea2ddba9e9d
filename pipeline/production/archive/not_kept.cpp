#include "pipeline/production/archive/not_kept.h"

#include <map>
#include <system_error>

#include <nlohmann/json.hpp>

#include "motion/error.h"
#include "motion/text/file_contents.h"
#include "motion/text/json_depth.h"
#include "motion/text/safe_name.h"
#include "pipeline/base/documents/files.h"

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

}  // namespace

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
