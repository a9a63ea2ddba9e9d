#include "pipeline/production/provenance.h"

#include <map>

#include <nlohmann/json.hpp>

#include "pipeline/manifest/example_files.h"
#include "pipeline/tasks/code_identity.h"
#include "pipeline/tasks/hash.h"
#include "scenes/character/character.h"
#include "scenes/figures/figure.h"

namespace mien::pipeline {

namespace {

using nlohmann::ordered_json;

/// Inputs by name and the name of their folder; where that folder lies is the machine's affair.
std::map<std::string, Hash> inputs_of(const Manifest& manifest) {
  std::map<std::string, Hash> inputs;
  const auto add = [&](const std::filesystem::path& file) {
    const auto name = file.parent_path().filename() / file.filename();
    inputs[name.generic_string()] = hash_of_file(file);
  };
  for (const std::filesystem::path& file : repertoire_files(manifest)) add(file);
  for (const Stimulus* film : films_of(manifest)) {
    if (film->clip) add(film->clip->file);
    if (!film->look.scene_file.empty()) add(film->look.scene_file);
    if (const auto* character = scenes::character_in(film->look.figure)) {
      add(character->file);
      for (const auto& part : scenes::parts_of_character(character->file)) add(part);
    }
  }
  return inputs;
}

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

}  // namespace

std::string provenance(const Manifest& manifest, const std::vector<TaskOutcome>& outcomes) {
  ordered_json libraries = ordered_json::object();
  for (const auto& [name, version] : library_versions()) libraries[name] = version;
  ordered_json inputs = ordered_json::object();
  for (const auto& [path, hash] : inputs_of(manifest)) inputs[path] = hash;
  const ordered_json record = {
      {"mien", program_version()},
      {"study", manifest.study},
      {"seed", manifest.seed},
      {"hash", "XXH3-128"},
      {"manifest",
       {{"file", manifest.file.filename().string()}, {"hash", hash_of_file(manifest.file)}}},
      {"code", {{"motion", motion_code()}, {"film", film_code()}, {"pipeline", pipeline_code()}}},
      {"libraries", libraries},
      {"inputs", inputs},
      {"artifacts", artifacts_of(outcomes)}};
  return record.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace mien::pipeline
