#include "pipeline/study/studio/manifest_file.h"

#include <utility>

#include "motion/text/file_contents.h"
#include "pipeline/base/documents/fault.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/manifest/checks/checked_manifest.h"
#include "pipeline/study/server/session_store.h"
#include "pipeline/study/studio/manifest_edit.h"
#include "pipeline/tasks/hash.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

/// Behind a link lies what is written.
fs::path real_place(const fs::path& file) {
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
    state_ = state_of(std::move(*begun_from));
    return;
  }
  // What is no manifest at all is told as `mien check` tells it.
  load_manifest(file_, environment_);
  reload();
}

ManifestState ManifestFile::state_of(std::string text) const {
  ManifestState state;
  state.document = document_of(text, file_.string(), environment_);
  state.version = hash_of(text);
  state.text = std::move(text);
  return state;
}

std::optional<std::string> ManifestFile::text_on_disk() const {
  return motion::bytes_of_file(file_, motion::most_of_document).bytes;
}

ManifestState ManifestFile::state() const {
  const std::lock_guard lock(mutex_);
  return state_;
}

bool ManifestFile::is_on_disk() const {
  const std::lock_guard lock(mutex_);
  return is_on_disk_;
}

std::string ManifestFile::text_for(const nlohmann::ordered_json& wanted) const {
  const ManifestState now = state();
  return edited(now.text, file_.string(), changes_between(now.document, wanted), environment_);
}

ManifestState ManifestFile::reload() {
  const std::lock_guard lock(mutex_);
  const std::optional<std::string> text = text_on_disk();
  if (!text) throw Error({file_.string()}, "cannot be read any more", "put it back, or save it");
  refuse_faults(*text, file_, environment_);
  state_ = state_of(*text);
  is_on_disk_ = true;
  return state_;
}

void ManifestFile::write(const std::string& text) const {
  const fs::path real = real_place(file_);
  const fs::path next = real.parent_path() / ("." + real.filename().string() + "." + random_link());
  std::error_code unknown;
  const fs::file_status before = fs::status(real, unknown);
  write_file(next, "");
  if (fs::exists(before)) fs::permissions(next, before.permissions(), unknown);
  replace_file(real, next, text);
}

Saving ManifestFile::save(const nlohmann::ordered_json& wanted, const std::string& version,
                          bool over) {
  const std::lock_guard lock(mutex_);
  ManifestState base = state_;
  const std::optional<std::string> found = text_on_disk();
  const bool is_other = found ? *found != state_.text : is_on_disk_;
  if (!over && (is_other || version != state_.version))
    return {Saving::Outcome::elsewhere, found ? state_of(*found) : state_};
  if (found && is_other) base = state_of(*found);
  const std::string text =
      edited(base.text, file_.string(), changes_between(base.document, wanted), environment_);
  if (found && text == *found) {
    state_ = std::move(base);
    return {Saving::Outcome::unchanged, state_};
  }
  refuse_faults(text, file_, environment_);
  write(text);
  state_ = state_of(text);
  is_on_disk_ = true;
  return {Saving::Outcome::saved, state_};
}

}  // namespace mien::pipeline
