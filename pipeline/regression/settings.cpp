#include "pipeline/regression/settings.h"

#include <algorithm>
#include <map>
#include <utility>

#include "pipeline/base/reading/field_writer.h"
#include "pipeline/manifest/example_files.h"
#include "pipeline/manifest/look/point_form.h"
#include "pipeline/manifest/look/set_fields.h"
#include "pipeline/manifest/people.h"
#include "pipeline/tasks/hash.h"
#include "scenes/cameras/camera_settings.h"
#include "scenes/character/character.h"
#include "scenes/figures/figure.h"

namespace mien::pipeline {

namespace {

/// fps and in_place count as what they change first.
Aspect aspect_of(const FieldEntry& entry) {
  if ((entry.concerns & concerns::drawing) != 0) return Aspect::drawing;
  if ((entry.concerns & (concerns::motion | concerns::repertoire)) != 0) return Aspect::motion;
  if ((entry.concerns & concerns::picture) != 0) return Aspect::scene;
  return Aspect::video;
}

bool holds_maps(const OrderedJson& array) { return !array.empty() && array.front().is_object(); }

/// Maps, and lists of maps, are listed value by value.
void add_value(std::vector<Setting>& settings, const std::string& path, Aspect aspect,
               const OrderedJson& value) {
  if (value.is_object()) {
    for (const auto& [key, member] : value.items())
      add_value(settings, path + "." + key, aspect, member);
  } else if (value.is_array() && holds_maps(value)) {
    for (std::size_t i = 0; i < value.size(); ++i)
      add_value(settings, path + "[" + std::to_string(i) + "]", aspect, value[i]);
  } else if (!value.is_null()) {
    settings.push_back({path, aspect, value.dump()});
  }
}

/// The beginning of a hash distinguishes versions of a file.
std::string content_id(const Hash& hash) { return hash.substr(0, 12); }

/// Files by their names, and with the folder where two have one name.
std::string contents_of(const std::vector<std::filesystem::path>& files, FileKeys& keys) {
  OrderedJson contents = OrderedJson::object();
  for (const std::filesystem::path& file : files) {
    std::string name = file.filename().string();
    if (contents.contains(name)) name = (file.parent_path().filename() / name).generic_string();
    contents[name] = content_id(keys.of(file));
  }
  return contents.dump();
}

void add_entries(std::vector<Setting>& settings, const std::vector<FieldEntry>& entries,
                 FileKeys& files) {
  for (const FieldEntry& entry : entries) {
    add_value(settings, entry.path, aspect_of(entry), entry.value);
    if (!entry.files.empty())
      settings.push_back(
          {entry.path + content_words, aspect_of(entry), contents_of(entry.files, files)});
  }
}

/// Adds the default view, and the name of a figure without options, so that other values are
/// reported as differences from these.
void add_look(std::vector<Setting>& settings, const scenes::CameraSettings& camera,
              const std::vector<FieldEntry>& entries) {
  const auto figure = std::ranges::find(entries, "look.figure", &FieldEntry::path);
  if (figure != entries.end() && figure->value.is_object() && figure->value.size() == 1)
    settings.push_back(
        {"look.figure", Aspect::scene, OrderedJson(figure->value.begin().key()).dump()});
  const bool has_view = !camera.position && camera.path.empty();
  if (has_view && camera.view == scenes::CameraSettings{}.view)
    settings.push_back({"look.camera.view", Aspect::scene, OrderedJson(camera.view).dump()});
}

/// Adds the content of a set; the name of its file does not matter.
void add_set(std::vector<Setting>& settings, const scenes::SetPlan& set) {
  for (const FieldEntry& entry : entries_of(set, {.for_key = true}))
    if (entry.concerns != concerns::nothing)
      add_value(settings, "set." + entry.path, Aspect::scene, entry.value);
}

/// A character counts with the pictures and buffers that it refers to.
void add_character(std::vector<Setting>& settings, const Stimulus& stimulus, FileKeys& files) {
  const std::filesystem::path* file = scenes::file_of(stimulus.look.figure);
  if (file == nullptr) return;
  const OrderedJson content = {{file->filename().string(), content_id(files.of_character(*file))}};
  settings.push_back({"look.figure content", Aspect::scene, content.dump()});
}

/// The options of what is filmed, with its set and its character. `film` is the film's stimulus.
template <class Filmed>
std::vector<Setting> film_settings(const Filmed& filmed, const Stimulus& film, FileKeys& files) {
  const WritingOptions how{.for_key = true,
                           .concerned = concerns::motion | concerns::picture | concerns::stored |
                                        concerns::shown | concerns::files};
  std::vector<Setting> settings;
  const std::vector<FieldEntry> entries = entries_of(filmed, how);
  add_entries(settings, entries, files);
  add_look(settings, film.look.camera, entries);
  std::erase_if(settings, [](const Setting& setting) {
    return setting.path == "look.scene_file content" ||  // as its options
           setting.path == "look.figure content";        // with what belongs to it
  });
  add_character(settings, film, files);
  add_set(settings, film.look.set);
  return settings;
}

/// The sound that another stimulus states, which is not among the stimulus's own options.
void add_foreign_sound(std::vector<Setting>& settings, const Stimulus& stimulus, FileKeys& files) {
  if (!stimulus.sound || stimulus.sound->of == stimulus.id) return;
  const StimulusSound& sound = *stimulus.sound;
  settings.push_back({"audio.of", Aspect::video, OrderedJson(sound.of).dump()});
  settings.push_back({"audio.of.offset", Aspect::video, OrderedJson(sound.offset).dump()});
  settings.push_back({"audio.of.gain", Aspect::video, OrderedJson(sound.gain).dump()});
  settings.push_back({"audio.of content", Aspect::video, contents_of({sound.file}, files)});
}

/// The examples' files: each by its name, or as one where there are very many.
void add_examples(std::vector<Setting>& settings, const Manifest& manifest, FileKeys& files) {
  const std::vector<std::filesystem::path> examples = repertoire_files(manifest);
  if (examples.empty()) return;
  constexpr std::size_t most_named = 200;
  std::string content = contents_of(examples, files);
  if (examples.size() > most_named) {
    const std::string name = std::to_string(examples.size()) + " files";
    content = OrderedJson({{name, content_id(hash_of(content))}}).dump();
  }
  settings.push_back({"examples content", Aspect::motion, std::move(content)});
}

/// Settings that are shared by all stimuli. Which examples there are follows from their content.
std::vector<FieldEntry> study_entries(const Manifest& manifest) {
  const WritingOptions how{
      .for_key = true, .concerned = concerns::repertoire | concerns::motion | concerns::picture};
  std::vector<FieldEntry> entries = entries_of(manifest, how);
  std::erase_if(entries, [](const FieldEntry& entry) {
    return entry.path != "recipes" && !entry.path.starts_with("examples") &&
           entry.path != "equalize";
  });
  for (FieldEntry& entry : entries)
    std::erase_if(entry.files,
                  [](const auto& file) { return std::filesystem::is_directory(file); });
  return entries;
}

/// What the options of a set's lights, walls, boxes and belt, and of the steps of a modification,
/// are by default.
std::map<std::string, std::string> usual_values() {
  std::map<std::string, std::string> usual;
  const auto add = [&](const std::string& path, const auto& prototype) {
    for (const FieldEntry& entry : entries_of(prototype, {.for_key = true}))
      if (!entry.value.is_null()) usual[path + entry.path] = entry.value.dump();
  };
  for (const char* step : {"modify.", "modify[]."}) {
    add(step, motion::Modification{});
    usual[std::string(step) + "strength"] = OrderedJson(ModificationStep{}.strength).dump();
  }
  add("set.lights[].", scenes::KeyLight{});
  add("set.walls[].", scenes::Wall{});
  add("set.boxes[].", scenes::Box{});
  add("set.belt.", scenes::Belt{});
  return usual;
}

/// "set.lights[" … "].", "set.belt." or "modify.": where what an option belongs to stands. Its
/// length; 0 for other options.
std::size_t owner_length(const std::string& path) {
  for (const std::string_view owner : {"set.belt.", "modify."})
    if (path.starts_with(owner)) return owner.size();
  const std::size_t end = path.find("].");
  const bool is_listed = path.starts_with("set.") || path.starts_with("modify[");
  return is_listed && end != std::string::npos ? end + 2 : 0;
}

/// Whether the step has an emotion, whose recipe replaces the defaults.
bool has_recipe(const std::string& owner, const std::vector<Setting>& settings) {
  return owner.starts_with("modify") &&
         std::ranges::find(settings, owner + "emotion", &Setting::path) != settings.end();
}

/// The default of an option that is not given, though its light, wall or step is; empty if there is
/// no such light, wall or step.
std::string usual_value(const std::string& path, const std::vector<Setting>& settings) {
  static const std::map<std::string, std::string> usual = usual_values();
  const std::size_t length = owner_length(path);
  const std::string owner = path.substr(0, length);
  const bool is_there = length != 0 && std::ranges::any_of(settings, [&](const Setting& one) {
                          return one.path.starts_with(owner);
                        });
  if (!is_there || (has_recipe(owner, settings) && !path.ends_with(".strength"))) return "";
  const std::size_t open = owner.find('[');
  const std::string kind = open == std::string::npos ? owner : owner.substr(0, open) + "[].";
  const auto found = usual.find(kind + path.substr(length));
  return found == usual.end() ? "" : found->second;
}

}  // namespace

std::vector<Setting> settings_of(const Stimulus& stimulus, const Manifest& manifest,
                                 FileKeys& files) {
  Stimulus itself = stimulus;
  itself.foil.reset();
  std::vector<Setting> settings = film_settings(itself, stimulus, files);
  add_foreign_sound(settings, stimulus, files);
  add_entries(settings, study_entries(manifest), files);
  add_examples(settings, manifest, files);
  settings.push_back({"seed", Aspect::drawing, std::to_string(manifest.seed)});
  return settings;
}

std::vector<Setting> settings_of(const Overlay& overlay, const Manifest& manifest,
                                 FileKeys& files) {
  std::vector<Setting> settings = film_settings(overlay, overlay.film, files);
  const auto motions = motions_on(overlay);
  const bool shows_example = std::ranges::any_of(
      motions, [&](const auto& one) { return film_showing(manifest, one.second) == nullptr; });
  if (shows_example) add_examples(settings, manifest, files);
  settings.push_back({"seed", Aspect::drawing, std::to_string(manifest.seed)});
  return settings;
}

std::vector<SettingChange> changes_between(const std::vector<Setting>& before,
                                           const std::vector<Setting>& now) {
  std::map<std::string_view, const Setting*> by_path;
  for (const Setting& setting : now) by_path[setting.path] = &setting;
  std::vector<SettingChange> changes;
  for (const Setting& setting : before) {
    const auto same = by_path.find(setting.path);
    const std::string value =
        same == by_path.end() ? usual_value(setting.path, now) : same->second->value;
    if (value != setting.value)
      changes.push_back({setting.path, setting.aspect, setting.value, value});
    if (same != by_path.end()) by_path.erase(same);
  }
  for (const Setting& setting : now) {
    if (!by_path.contains(setting.path)) continue;
    const std::string value = usual_value(setting.path, before);
    if (value != setting.value)
      changes.push_back({setting.path, setting.aspect, value, setting.value});
  }
  return changes;
}

}  // namespace mien::pipeline
