#include "pipeline/production/run/provenance.h"

#include <map>

#include <nlohmann/json.hpp>

#include "pipeline/base/documents/files.h"
#include "pipeline/base/reading/value_forms.h"
#include "pipeline/production/run/resolved_settings.h"
#include "pipeline/production/run/study_inputs.h"
#include "pipeline/tasks/code_identity.h"
#include "pipeline/tasks/hash.h"
#include "pipeline/tasks/receipt.h"

namespace mien::pipeline {

namespace {

using nlohmann::ordered_json;

ordered_json artifacts_of(const std::vector<TaskOutcome>& outcomes) {
  std::map<std::string, ordered_json> by_path;
  for (const TaskOutcome& outcome : outcomes) {
    for (const Receipt& product : outcome.products) {
      if (product.path.starts_with(".mien/")) continue;
      ordered_json entry = {{"hash", product.hash}, {"size", product.size}};
      if (!product.frames.empty()) entry["frames"] = product.frames.size();
      by_path[product.path] = entry;
    }
  }
  ordered_json artifacts = ordered_json::object();
  for (auto& [path, entry] : by_path) artifacts[path] = entry;
  return artifacts;
}

ordered_json stimuli_of(const Manifest& manifest) {
  ordered_json stimuli = ordered_json::array();
  for (const Stimulus& stimulus : manifest.stimuli) stimuli.push_back(resolved_settings(stimulus));
  return stimuli;
}

ordered_json overlays_of(const Manifest& manifest) {
  ordered_json overlays = ordered_json::array();
  for (const Overlay& overlay : manifest.overlays) overlays.push_back(resolved_settings(overlay));
  return overlays;
}

}  // namespace

std::string provenance(const Manifest& manifest, const std::vector<TaskOutcome>& outcomes) {
  ordered_json libraries = ordered_json::object();
  for (const auto& [name, version] : library_versions()) libraries[name] = version;
  ordered_json inputs = ordered_json::object();
  for (const auto& [path, hash] : hashes_of_inputs(manifest)) inputs[path] = hash;
  const ordered_json record = {
      {"mien", program_version()},
      {"command", manifest.command},
      {"study", manifest.study},
      {"seed", manifest.seed},
      {"hash", "XXH3-128"},
      {"manifest",
       {{"file", manifest.file.filename().string()},
        {"hash", hash_of_file(manifest.file)},
        {"copy", input_copies(manifest).front().path},
        {"as_run", as_run_path}}},
      {"code", {{"motion", motion_code()}, {"film", film_code()}, {"pipeline", study_code()}}},
      {"libraries", libraries},
      {"inputs", inputs},
      {"equalize", EqualizeForm::write(manifest.equalize, {})},
      {"stimuli", stimuli_of(manifest)},
      {"overlays", overlays_of(manifest)},
      {"artifacts", artifacts_of(outcomes)}};
  return record.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

std::vector<std::string> changes_since(const std::filesystem::path& provenance,
                                       const Manifest& manifest) {
  const ordered_json record = ordered_json::parse(read_file(provenance));
  std::vector<std::string> changes;
  if (const auto version = record.value("mien", ""); version != program_version()) {
    changes.push_back("it was made with mien " + version + ", and this is " +
                      std::string(program_version()));
  }
  const ordered_json before = record.value("inputs", ordered_json::object());
  for (const auto& [name, hash] : hashes_of_inputs(manifest)) {
    const bool is_same = before.contains(name) && before[name] == hash;
    if (!is_same) changes.push_back(name + " has changed");
  }
  const std::filesystem::path folder = provenance.parent_path();
  const auto as_run = read_receipt(folder, as_run_path);
  if (as_run && as_run->hash != hash_of_file(folder / as_run_path))
    changes.push_back(std::string(as_run_path) + " has changed");
  return changes;
}

}  // namespace mien::pipeline
