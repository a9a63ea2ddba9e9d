#include "pipeline/study/studio/manifest_file.h"

#include <utility>

#include "motion/text/file_contents.h"
#include "pipeline/base/documents/fault.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/base/reading/schema.h"
#include "pipeline/base/reading/yaml_json.h"
#include "pipeline/manifest/checks/checked_manifest.h"
#include "pipeline/study/server/session_store.h"
#include "pipeline/tasks/hash.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using nlohmann::ordered_json;

ordered_json in_written_order(const json& value, const std::string& path, const Places& places) {
  if (value.is_object()) {
    ordered_json map = ordered_json::object();
    for (const std::string& key : written_order(value, path, places))
      map[key] = in_written_order(value[key], member_path(path, key), places);
    return map;
  }
  if (!value.is_array()) return ordered_json(value);
  ordered_json array = ordered_json::array();
  for (std::size_t i = 0; i < value.size(); ++i)
    array.push_back(in_written_order(value[i], element_path(path, i), places));
  return array;
}

/// Parses a manifest's text, with members in the order of the text. Throws Faults for invalid YAML;
/// the schema is not checked.
ordered_json document_of(const std::string& text, const std::string& file,
                         const Environment& environment) {
  std::vector<Fault> faults;
  const JsonReading reading = read_json(text, file, manifest_schema(), environment, faults);
  if (!faults.empty()) throw Faults(std::move(faults));
  return in_written_order(reading.document, "", reading.places);
}

/// Resolves symbolic links, so that their target is written.
fs::path resolved_file(const fs::path& file) {
  std::error_code unknown;
  fs::path real = fs::canonical(file, unknown);
  return unknown ? file : real;
}

void refuse_faults(const std::string& text, const fs::path& file, const Environment& environment) {
  ManifestReading reading = check_manifest_text(text, file, environment);
  if (!reading.faults.empty()) throw Faults(std::move(reading.faults));
}

}  // namespace

ManifestFile::ManifestFile(fs::path file, Environment environment,
                           std::optional<std::string> begun_from)
    : file_(std::move(file)), environment_(std::move(environment)) {
  if (begun_from) {
    refuse_faults(*begun_from, file_, environment_);
    is_on_disk_ = false;
    state_ = state_of(std::move(*begun_from), false);
    return;
  }
  // Reports an unreadable manifest as `mien check` does.
  load_manifest(file_, environment_);
  reload();
}

ManifestState ManifestFile::state_of(std::string text, bool is_on_disk) const {
  ManifestState state;
  state.document = document_of(text, file_.string(), environment_);
  if (is_on_disk) state.version = hash_of(text);
  state.text = std::move(text);
  return state;
}

std::optional<std::string> ManifestFile::text_on_disk() const {
  return motion::bytes_of_file(file_, motion::max_document_bytes).bytes;
}

ManifestState ManifestFile::state() const {
  const std::lock_guard lock(mutex_);
  return state_;
}

bool ManifestFile::is_on_disk() const {
  const std::lock_guard lock(mutex_);
  return is_on_disk_;
}

ManifestState ManifestFile::reload() {
  const std::lock_guard lock(mutex_);
  const std::optional<std::string> text = text_on_disk();
  if (!text) throw Error({file_.string()}, "cannot be read any more", "restore it, or save it");
  refuse_faults(*text, file_, environment_);
  state_ = state_of(*text);
  is_on_disk_ = true;
  return state_;
}

void ManifestFile::write(const std::string& text) const {
  const fs::path real = resolved_file(file_);
  const fs::path next = real.parent_path() / ("." + real.filename().string() + "." + random_link());
  std::error_code unknown;
  const fs::file_status before = fs::status(real, unknown);
  write_file(next, "");
  if (fs::exists(before)) fs::permissions(next, before.permissions(), unknown);
  replace_file(real, next, text);
}

SaveResult ManifestFile::save(const std::string& text, const ordered_json& document,
                              const std::string& version) {
  const std::lock_guard lock(mutex_);
  const std::optional<std::string> found = text_on_disk();
  if (version != (found ? hash_of(*found) : ""))
    return {SaveResult::Outcome::elsewhere,
            found ? state_of(*found) : state_of(state_.text, false)};
  ManifestState next = state_of(text);
  if (json(next.document) != json(document))
    throw Error({file_.string()}, "the text to be saved differs from what the page shows",
                "edit the file by hand, and reload the page");
  const bool is_other = text != found;
  if (is_other) {
    refuse_faults(text, file_, environment_);
    write(text);
  }
  state_ = std::move(next);
  is_on_disk_ = true;
  return {is_other ? SaveResult::Outcome::saved : SaveResult::Outcome::unchanged, state_};
}

}  // namespace mien::pipeline
