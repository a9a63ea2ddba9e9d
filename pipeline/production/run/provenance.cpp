#include "pipeline/production/run/provenance.h"

#include <map>
#include <variant>

#include <nlohmann/json.hpp>

#include "pipeline/base/documents/files.h"
#include "pipeline/base/reading/field_values.h"
#include "pipeline/base/reading/field_writer.h"
#include "pipeline/base/reading/value_codecs.h"
#include "pipeline/manifest/look/look_fields.h"
#include "pipeline/manifest/look/point_form.h"
#include "pipeline/manifest/recording_files.h"
#include "pipeline/production/film/film.h"
#include "pipeline/production/run/study_inputs.h"
#include "pipeline/tasks/code_identity.h"
#include "pipeline/tasks/hash.h"
#include "pipeline/tasks/receipt.h"

namespace mien::pipeline {

namespace {

using nlohmann::ordered_json;

const WritingOptions by_name{.for_key = true};  // files by name

/// All that a struct says, with what it has anyway.
template <class Value>
OrderedJson all_of(const Value& value) {
  std::vector<FieldEntry> entries = entries_of(value, by_name);
  std::erase_if(entries, [](const FieldEntry& entry) { return entry.value.is_null(); });
  return nested_map(entries);
}

/// A figure with all its options; a name without options, or a file, is all that there is.
OrderedJson figure_of(const scenes::Figure& figure) {
  OrderedJson map = FigureForm<scenes::Figure>::write(figure, by_name);
  const auto complete = [&]<class Options>(const Options& options) {
    if constexpr (HasFields<const Options>) map.front() = all_of(options);
  };
  if (map.is_object()) std::visit(complete, figure);
  return map;
}

OrderedJson step_of(const ModificationStep& step) {
  OrderedJson map = OrderedJson::object();
  if (!step.emotion.empty()) map["emotion"] = step.emotion;
  map["strength"] = step.strength;
  map.update(step.style ? all_of(*step.style) : all_of(step.modification));
  if (step.pose) map["pose"] = all_of(*step.pose);
  if (!step.freeze.parts.empty()) map["freeze"] = FreezingForm::write(step.freeze, by_name);
  if (!step.drives.empty()) map["drives"] = written(step.drives, by_name);
  if (!step.keys.empty()) map["keys"] = written(step.keys, by_name);
  if (!step.constraints.empty()) map["constraints"] = written(step.constraints, by_name);
  if (!step.ends.is_empty()) map["ends"] = EndsForm::write(step.ends, by_name);
  return map;
}

OrderedJson film_of(const Stimulus& film) {
  OrderedJson map = all_of(film);
  const OrderedJson said = map["look"];
  map["look"] = {{"scene", said.value("scene", OrderedJson(scene_of(film.look)))},
                 {"figure", figure_of(film.look.figure)},
                 {"camera", all_of(film.look.camera)}};
  for (const auto& [key, value] : said.items()) {
    if (!map["look"].contains(key)) map["look"][key] = value;
  }
  map["output"]["samples_per_pixel"] =
      quality_of(FilmSettings{.output = film.output}).samples_per_pixel;
  return map;
}

/// Every setting of a stimulus or of an overlay's film as it was used, defaults and recipes filled
/// in: look, output, interpolation, each modification with its seed. Files are given by their
/// names.
OrderedJson resolved_settings(const Stimulus& stimulus) {
  OrderedJson map = film_of(stimulus);
  map.erase("modify");
  if (stimulus.modify.empty()) map.erase("on_fault");
  if (!is_blend(stimulus)) map.erase("interpolation");
  for (const ModificationStep& step : stimulus.modify) map["modify"].push_back(step_of(step));
  for (std::size_t i = 0; i < stimulus.people.size(); ++i) {
    const Person& person = stimulus.people[i];
    OrderedJson& own = map["people"][i];
    own["name"] = person.name;
    own.erase("modify");
    for (const ModificationStep& step : person.motion.modify)
      own["modify"].push_back(step_of(step));
  }
  return map;
}

OrderedJson resolved_settings(const Overlay& overlay) {
  const OrderedJson film = film_of(overlay.film);
  OrderedJson map = all_of(overlay);
  map["look"] = film["look"];
  map["output"] = film["output"];
  return map;
}

/// The licences that do not permit sharing a file of clips/, by its path.
std::map<std::string, std::vector<std::string>> restricted_clips(
    const Manifest& manifest, const std::vector<RecordingFile>& recordings) {
  std::map<std::string, std::vector<std::string>> restricted;
  for (const Stimulus& stimulus : manifest.stimuli) {
    const std::vector<std::string> licences = restricting_licences(stimulus, recordings);
    if (licences.empty()) continue;
    std::vector<std::string> endings = stimulus.output.clips;
    endings.emplace_back("dots.csv");
    for (const std::string& ending : endings)
      restricted["clips/" + stimulus.id + "." + ending] = licences;
    for (const Person& person : stimulus.people) {
      const auto own = restricting_licences(person.motion, recordings);
      if (own.empty()) continue;
      for (const std::string& ending : stimulus.output.clips)
        restricted["clips/" + person.motion.id + "." + ending] = own;
    }
  }
  return restricted;
}

ordered_json artifacts_of(const std::vector<TaskOutcome>& outcomes,
                          const std::map<std::string, std::vector<std::string>>& restricted) {
  std::map<std::string, ordered_json> by_path;
  for (const TaskOutcome& outcome : outcomes) {
    for (const Receipt& product : outcome.products) {
      if (product.path.starts_with(".mien/")) continue;
      ordered_json entry = {{"hash", product.hash}, {"size", product.size}};
      if (!product.frames.empty()) entry["frames"] = product.frames.size();
      const auto licences = restricted.find(product.path);
      if (licences != restricted.end()) entry["not_shared"] = licences->second;
      by_path[product.path] = entry;
    }
  }
  ordered_json artifacts = ordered_json::object();
  for (auto& [path, entry] : by_path) artifacts[path] = entry;
  return artifacts;
}

/// The motion files, with what the manifest states about them.
ordered_json recordings_of(const Manifest& manifest, const std::vector<RecordingFile>& recordings,
                           const std::map<std::string, Hash>& hashes) {
  const std::map<std::filesystem::path, std::string> names = names_of_uncopied_inputs(manifest);
  std::map<std::string, ordered_json> entries;
  for (const RecordingFile& recording : recordings) {
    std::vector<std::filesystem::path> files = recording.parts;
    files.insert(files.begin(), recording.file);
    for (const std::filesystem::path& file : files) {
      const auto name = names.find(std::filesystem::absolute(file).lexically_normal());
      if (name == names.end()) continue;
      ordered_json entry = {{"path", name->second}, {"hash", hashes.at(name->second)}};
      if (!recording.source.empty()) entry["source"] = recording.source;
      if (!recording.licence.name.empty()) entry["licence"] = recording.licence.name;
      if (!recording.licence.share) entry["share"] = false;
      const bool is_restricted = entries[name->second].contains("share");
      if (!is_restricted) entries[name->second] = entry;  // a companion may belong to several
    }
  }
  ordered_json list = ordered_json::array();
  for (const auto& [name, entry] : entries) list.push_back(entry);
  return list;
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
  const std::map<std::string, Hash> hashes = hashes_of_inputs(manifest);
  for (const auto& [path, hash] : hashes) inputs[path] = hash;
  const std::vector<RecordingFile> recordings = recording_files(manifest);
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
      {"recordings", recordings_of(manifest, recordings, hashes)},
      {"equalize", EqualizeForm::write(manifest.equalize, {})},
      {"stimuli", stimuli_of(manifest)},
      {"overlays", overlays_of(manifest)},
      {"artifacts", artifacts_of(outcomes, restricted_clips(manifest, recordings))}};
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
