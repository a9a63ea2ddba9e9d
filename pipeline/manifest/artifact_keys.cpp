#include "pipeline/manifest/artifact_keys.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "pipeline/look/point_form.h"
#include "pipeline/look/set_fields.h"
#include "pipeline/manifest/example_files.h"
#include "pipeline/reading/field_writer.h"
#include "pipeline/tasks/code_identity.h"
#include "scenes/character/character.h"
#include "scenes/figures/figure.h"

namespace mien::pipeline {

namespace {

/// What of a struct concerns an artifact, and is not as it is unless told; with the files it names.
template <class Value>
void add_fields(KeyBuilder& key, const std::string& name, const Value& value, unsigned concerned) {
  const Writing how{.for_key = true};
  for (const FieldEntry& entry : differences(entries_of(value, how), entries_of(Value{}, how))) {
    if ((entry.concerns & concerned) == 0) continue;
    key.add(name + entry.path, entry.value.dump());
    for (const std::filesystem::path& file : entry.files) add_file(key, file);
  }
}

void add_steps(KeyBuilder& key, const Stimulus& stimulus) {
  for (const ModificationStep& step : stimulus.modify) {
    key.add("modify", step.emotion).add("strength", step.strength);
    add_fields(key, "modify.", step.modification, concerns::motion);
    if (step.style) add_fields(key, "style.", *step.style, concerns::motion);
    if (step.pose) add_fields(key, "pose.", *step.pose, concerns::motion);
  }
}

/// With the buffers and pictures that its file refers to.
void add_character(KeyBuilder& key, const std::filesystem::path& file) {
  add_file(key, file);
  for (const std::filesystem::path& part : scenes::parts_of_character(file)) add_file(key, part);
}

/// A set counts by what it holds, whatever its file is called.
void add_set(KeyBuilder& key, const scenes::SetPlan& set) {
  for (const FieldEntry& entry : entries_of(set, {.for_key = true})) {
    if (entry.concerns != concerns::nothing) key.add("set." + entry.path, entry.value.dump());
  }
}

Hash libraries_key() {
  KeyBuilder key;
  for (const auto& [name, version] : library_versions()) key.add(name, version);
  return key.key();
}

Hash repertoire_key(const Manifest& manifest) {
  KeyBuilder key;
  key.add("seed", static_cast<std::int64_t>(manifest.seed));
  const Writing how{.for_key = true};
  for (const FieldEntry& entry : entries_of(manifest, how)) {
    if ((entry.concerns & concerns::repertoire) != 0) key.add(entry.path, entry.value.dump());
  }
  for (const std::filesystem::path& file : repertoire_files(manifest)) add_file(key, file);
  // Answers may be about files that are left out: those are no strangers.
  if (manifest.ratings.source == Ratings::Source::file) {
    for (const std::string& stem : stems_in_folder(manifest.examples)) key.add("stem", stem);
  }
  return key.key();
}

}  // namespace

SharedDeterminants shared_determinants(const Manifest& manifest) {
  return {libraries_key(), repertoire_key(manifest)};
}

void add_file(KeyBuilder& key, const std::filesystem::path& file) {
  key.add("file", file.filename().string()).add("content", hash_of_file(file));
  for (const std::filesystem::path& part : motion_parts(file)) {
    key.add("part", part.filename().string()).add("content", hash_of_file(part));
  }
}

void add_motion(KeyBuilder& key, const Stimulus& stimulus) {
  Stimulus without =
      stimulus;  // whose modifications count as they were resolved, and not as written
  without.modify.clear();
  without.foil.reset();
  add_fields(key, "", without, concerns::motion);
  add_steps(key, stimulus);
  const Hold& hold = stimulus.hold;
  if (hold.others || !hold.names.empty()) {
    for (const Stimulus& reference : hold.reference) add_motion(key, reference);
  }
  key.add("blends seed", static_cast<std::int64_t>(stimulus.interpolation.weights.nearest.seed));
}

void add_interpolation(KeyBuilder& key, const Interpolation& how) {
  add_fields(key, "interpolation.", how, concerns::motion);
  key.add("blends seed", static_cast<std::int64_t>(how.weights.nearest.seed));
}

void add_film(KeyBuilder& key, const Stimulus& stimulus) {
  add_fields(key, "", stimulus, concerns::picture);
  add_set(key, stimulus.look.set);
  if (std::holds_alternative<scenes::PointLightOptions>(stimulus.look.figure))
    key.add("dots of", stimulus.id);
  if (const auto* character = scenes::character_in(stimulus.look.figure))
    add_character(key, character->file);
}

void add_page(KeyBuilder& key, const Manifest& manifest) {
  for (const FieldEntry& entry : entries_of(manifest, {.for_key = true})) {
    if ((entry.concerns & concerns::page) != 0) key.add(entry.path, entry.value.dump());
  }
  for (const Stimulus& stimulus : manifest.stimuli) {
    for (const auto& [factor, level] : stimulus.factors)
      key.add("factor", factor).add("level", level);
  }
}

void add_presentation(KeyBuilder& key, const Presentation& presentation) {
  add_fields(key, "presentation.", presentation, concerns::shown);
}

}  // namespace mien::pipeline
