#include "pipeline/manifest/determinants.h"

#include <cstdint>
#include <string>
#include <vector>

#include "pipeline/base/reading/field_writer.h"
#include "pipeline/manifest/example_files.h"
#include "pipeline/manifest/look/point_form.h"
#include "pipeline/manifest/look/set_fields.h"
#include "pipeline/manifest/recording_files.h"
#include "pipeline/tasks/code_identity.h"
#include "render/video/sound_file.h"
#include "scenes/character/character.h"
#include "scenes/figures/figure.h"

namespace mien::pipeline {

namespace {

/// The fields of a struct that concern an artifact and differ from their defaults, with the files
/// they name.
template <class Value>
void add_fields(KeyBuilder& key, const std::string& name, const Value& value, unsigned concerned,
                FileKeys& files) {
  static const std::vector<FieldEntry> usual = entries_of(Value{}, {.for_key = true});
  const WritingOptions how{.for_key = true, .concerned = concerned};
  for (const FieldEntry& entry : differences(entries_of(value, how), usual)) {
    key.add(name + entry.path, entry.value.dump());
    for (const std::filesystem::path& file : entry.files) key.add("file", files.of(file));
  }
}

void add_steps(KeyBuilder& key, const Stimulus& stimulus, FileKeys& files) {
  for (const ModificationStep& mood : stimulus.walk_moods) {
    key.add("mood", mood.emotion);
    add_fields(key, "mood.", mood.modification, concerns::motion, files);
  }
  for (const ModificationStep& step : stimulus.modify) {
    key.add("modify", step.emotion).add("strength", step.strength);
    add_fields(key, "modify.", step.modification, concerns::motion, files);
    if (step.style) add_fields(key, "style.", *step.style, concerns::motion, files);
    if (step.pose) add_fields(key, "pose.", *step.pose, concerns::motion, files);
    const WritingOptions how{.for_key = true};
    if (!step.freeze.parts.empty())
      key.add("modify.freeze", FreezingForm::write(step.freeze, how).dump());
    if (!step.drives.empty()) key.add("modify.drives", written(step.drives, how).dump());
    if (!step.keys.empty()) key.add("modify.keys", written(step.keys, how).dump());
    if (!step.constraints.empty())
      key.add("modify.constraints", written(step.constraints, how).dump());
    if (!step.ends.is_empty()) key.add("modify.ends", EndsForm::write(step.ends, how).dump());
  }
}

/// Adds the content of a set; the name of its file does not matter.
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

Hash repertoire_key(const Manifest& manifest, FileKeys& files) {
  KeyBuilder key;
  key.add("seed", static_cast<std::int64_t>(manifest.seed));
  const WritingOptions how{.for_key = true, .concerned = concerns::repertoire};
  for (const FieldEntry& entry : entries_of(manifest, how)) key.add(entry.path, entry.value.dump());
  for (const std::filesystem::path& file : repertoire_files(manifest))
    key.add("file", files.of(file));
  // Answers about files that are excluded are not answers about unknown examples.
  if (manifest.ratings.source == Ratings::Source::file) {
    for (const std::string& stem : stems_in_folder(manifest.examples)) key.add("stem", stem);
  }
  return key.key();
}

}  // namespace

SharedDeterminants shared_determinants(const Manifest& manifest, FileKeys& files) {
  // What identifies participants is not in the copy from which the study is made again.
  if (manifest.ratings.source == Ratings::Source::file)
    files.set(manifest.ratings.file, hash_of(kept_ratings(manifest)));
  return {libraries_key(), repertoire_key(manifest, files), files};
}

void add_motion(KeyBuilder& key, const Stimulus& stimulus, FileKeys& files) {
  Stimulus without =
      stimulus;  // whose modifications count as they were resolved, and not as written
  without.modify.clear();
  without.foil.reset();
  add_fields(key, "", without, concerns::motion, files);
  add_steps(key, stimulus, files);
  const Hold& hold = stimulus.hold;
  if (hold.others || !hold.names.empty()) {
    for (const Stimulus& reference : hold.reference) add_motion(key, reference, files);
  }
  key.add("blends seed", static_cast<std::int64_t>(stimulus.interpolation.weights.nearest.seed));
}

void add_interpolation(KeyBuilder& key, const Interpolation& how) {
  FileKeys none;
  add_fields(key, "interpolation.", how, concerns::motion, none);
  key.add("blends seed", static_cast<std::int64_t>(how.weights.nearest.seed));
}

void add_film(KeyBuilder& key, const Stimulus& stimulus, FileKeys& files) {
  Stimulus shown = stimulus;
  if (shown.look.colours == Colours::neutral) shown.role = Stimulus().role;
  add_fields(key, "", shown, concerns::picture, files);
  add_set(key, stimulus.look.set);
  for (const Person& person : stimulus.people) {
    if (!person.figure) continue;
    if (const auto* file = scenes::file_of(*person.figure))
      key.add("character of " + person.name, files.of_character(*file));
  }
  if (scenes::kind_of(stimulus.look.figure).has_dots) key.add("dots of", stimulus.id);
  if (const auto* file = scenes::file_of(stimulus.look.figure))
    key.add("character", files.of_character(*file));
}

void add_page(KeyBuilder& key, const Manifest& manifest) {
  for (const FieldEntry& entry : entries_of(manifest, {.for_key = true}))
    key.add(entry.path, entry.value.dump());
  for (const Stimulus& stimulus : manifest.stimuli) {
    for (const auto& [factor, level] : stimulus.factors)
      key.add("factor", factor).add("level", level);
  }
  for (const RecordingFile& recording : recording_files(manifest)) {
    key.add("recording", recording.file.filename().string())
        .add("licence", recording.licence.name)
        .add("share", std::int64_t{recording.licence.share})
        .add("source", recording.source);
  }
}

void add_sound(KeyBuilder& key, const Stimulus& stimulus, const Equalize& equalize,
               FileKeys& files) {
  if (!stimulus.sound) return;
  const StimulusSound& sound = *stimulus.sound;
  key.add("sound", files.of(sound.file))
      .add("sound offset", sound.offset)
      .add("sound gain", sound.gain)
      .add("sound length", name_of(sound.length))
      .add("sound of", sound.of)
      .add("sound libraries", render::sound_libraries());
  if (equalize.loudness) key.add("loudness", *equalize.loudness);
}

void add_presentation(KeyBuilder& key, const Presentation& presentation) {
  FileKeys none;
  add_fields(key, "presentation.", presentation, concerns::shown, none);
}

}  // namespace mien::pipeline
