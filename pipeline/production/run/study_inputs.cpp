#include "pipeline/production/run/study_inputs.h"

#include <algorithm>
#include <set>
#include <type_traits>

#include "pipeline/base/documents/files.h"
#include "pipeline/manifest/example_files.h"
#include "pipeline/manifest/people.h"
#include "pipeline/manifest/reading/manifest_yaml.h"
#include "pipeline/manifest/study_texts.h"
#include "scenes/character/character.h"
#include "scenes/face/face_animation.h"
#include "scenes/figures/figure.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

/// Calls `visit` with each file of texts for participants.
void visit_text_files(auto& experiment, const auto& visit) {
  visit_texts(experiment, [&](const std::string&, auto& text) {
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(text)>, TextSource>) {
      if (!text.file.empty()) visit(text.file);
      for (auto& [language, translated] : text.by_language)
        if (!translated.file.empty()) visit(translated.file);
    }
  });
  for (auto& file : experiment.texts.files) visit(file);
}

/// Calls `visit` with each path of a manifest that names a file of which a copy is kept.
template <MaybeConst<Manifest> M, class Visit>
void for_each_document(M& manifest, const Visit& visit) {
  if (!manifest.scales.file.empty()) visit(manifest.scales.file);
  if (!manifest.recipes.file.empty()) visit(manifest.recipes.file);
  if (manifest.ratings.source == Ratings::Source::file) visit(manifest.ratings.file);
  const auto visit_set = [&](auto& look) {
    if (!look.scene_file.empty()) visit(look.scene_file);
  };
  if (manifest.questionnaire) {
    auto& questionnaire = *manifest.questionnaire;
    visit_text_files(questionnaire, visit);
    if (!questionnaire.analysis.plan.file.empty()) visit(questionnaire.analysis.plan.file);
    if (!questionnaire.scales.file.empty()) visit(questionnaire.scales.file);
  }
  if (manifest.matching) visit_text_files(*manifest.matching, visit);
  if (manifest.adaptive) visit_text_files(*manifest.adaptive, visit);
  for (auto& stimulus : manifest.stimuli)
    if (stimulus.audio && !stimulus.audio->file.empty()) visit(stimulus.audio->file);
  visit_set(manifest.look);
  for (auto& stimulus : manifest.stimuli) visit_set(stimulus.look);
  for (auto& overlay : manifest.overlays) visit_set(overlay.film.look);
}

/// Where a copy lies below inputs/: as it lies below the manifest's folder, or by its name alone.
fs::path place_of(const fs::path& file, const fs::path& folder) {
  const fs::path below = fs::proximate(file, folder.empty() ? "." : folder);
  const bool is_outside = below.is_absolute() || below.empty() || *below.begin() == "..";
  return is_outside ? file.filename() : below;
}

bool is_taken(const std::vector<InputCopy>& copies, const std::string& path) {
  return path == as_run_path || std::ranges::find(copies, path, &InputCopy::path) != copies.end();
}

void add_copy(std::vector<InputCopy>& copies, const fs::path& file, const fs::path& folder) {
  if (std::ranges::find(copies, file, &InputCopy::source) != copies.end()) return;
  const fs::path place = place_of(file, folder);
  std::string path = "inputs/" + place.generic_string();
  for (int number = 2; is_taken(copies, path); ++number) {
    const std::string name = std::to_string(number) + "-" + place.filename().string();
    path = "inputs/" + (place.parent_path() / name).generic_string();
  }
  copies.push_back({file, path});
}

/// The manifest as it can be run from its copies in `folder`.
Manifest as_run(Manifest manifest, const std::vector<InputCopy>& copies, const fs::path& folder) {
  for_each_document(manifest, [&](fs::path& file) {
    const auto copy = std::ranges::find(copies, file, &InputCopy::source);
    if (copy != copies.end()) file = folder / copy->path;
  });
  return manifest;
}

void put_text(Store& store, const std::string& path, const std::string& text) {
  const Hash key = hash_of(text);
  if (store.find(path, key)) return;
  store.put(
      path, key, [&](const fs::path& file) { write_file(file, text); }, [](const fs::path&) {});
}

bool are_ratings(const Manifest& manifest, const InputCopy& copy) {
  return manifest.ratings.source == Ratings::Source::file && copy.source == manifest.ratings.file;
}

void add_motion_file(std::vector<fs::path>& files, const fs::path& file) {
  if (file.empty()) return;
  files.push_back(file);
  for (const fs::path& part : motion_parts(file)) files.push_back(part);
}

/// A motion file with its companion files and the model of its body.
void add_recording(std::vector<fs::path>& files, const fs::path& file, const RecordingChoice& how) {
  add_motion_file(files, file);
  if (!how.body_model.empty()) files.push_back(how.body_model);
}

/// All motion files of one motion.
void add_recordings(std::vector<fs::path>& files, const Stimulus& motion) {
  if (motion.clip) add_recording(files, motion.clip->file, motion.clip->how);
  if (motion.walk) {
    for (const GraphMotion& part : motion.walk->graph) add_recording(files, part.file, part.how);
  }
  for (const ModificationStep& step : motion.modify) {
    if (!step.pose) continue;
    add_recording(files, step.pose->neutral.file, step.pose->neutral.how);
    add_recording(files, step.pose->posed.file, step.pose->posed.how);
  }
}

void add_character(std::vector<fs::path>& files, const scenes::Figure& figure) {
  const fs::path* file = scenes::file_of(figure);
  if (file == nullptr) return;
  files.push_back(*file);
  for (const fs::path& part : scenes::files_of_character(*file)) files.push_back(part);
}

/// The file of a face's weights, with the buffers of a glTF file.
void add_face(std::vector<fs::path>& files, const scenes::Face& face) {
  if (face.file.empty()) return;
  files.push_back(face.file);
  if (!scenes::is_gltf_file(face.file)) return;
  for (const fs::path& part : motion_parts(face.file)) files.push_back(part);
}

/// Motions and characters, with the files that belong to them, each once.
std::vector<fs::path> uncopied_files(const Manifest& manifest) {
  std::vector<fs::path> files;
  for (const fs::path& file : repertoire_files(manifest)) add_motion_file(files, file);
  for (const Stimulus* film : films_of(manifest)) {
    add_character(files, film->look.figure);
    add_face(files, film->look.face);
    for (const Person& person : film->people) {
      if (person.figure) add_character(files, *person.figure);
      if (person.face) add_face(files, *person.face);
      if (person.stated) add_recordings(files, *person.stated);
    }
    for (const Stimulus* motion : motions_in(*film)) add_recordings(files, *motion);
  }
  std::sort(files.begin(), files.end());
  files.erase(std::unique(files.begin(), files.end()), files.end());
  return files;
}

}  // namespace

std::vector<InputCopy> input_copies(const Manifest& manifest) {
  const fs::path folder = manifest.file.parent_path();
  std::vector<InputCopy> copies;
  add_copy(copies, manifest.file, folder);
  for_each_document(manifest, [&](const fs::path& file) { add_copy(copies, file, folder); });
  return copies;
}

std::string contents_of_copy(const Manifest& manifest, const InputCopy& copy) {
  return are_ratings(manifest, copy) ? kept_ratings(manifest) : read_file(copy.source);
}

void put_inputs(const Manifest& manifest, const std::map<std::string, Hash>& as_read,
                Store& store) {
  for (const auto& [name, hash] : hashes_of_inputs(manifest)) {
    const auto before = as_read.find(name);
    if (before != as_read.end() && before->second == hash) continue;
    throw Error(name + " was changed during the run",
                "run it again: only what depends on the change is made again");
  }
  const std::vector<InputCopy> copies = input_copies(manifest);
  for (const InputCopy& copy : copies) put_text(store, copy.path, contents_of_copy(manifest, copy));
  const Manifest again = as_run(manifest, copies, store.folder());
  const fs::path folder = (store.folder() / as_run_path).parent_path();
  put_text(store, as_run_path, manifest_yaml(again, folder));
}

std::map<fs::path, std::string> names_of_uncopied_inputs(const Manifest& manifest) {
  const std::vector<InputCopy> copies = input_copies(manifest);
  std::set<fs::path> files;
  for (const fs::path& file : uncopied_files(manifest)) {
    if (std::ranges::find(copies, file, &InputCopy::source) != copies.end()) continue;
    files.insert(fs::absolute(file).lexically_normal());
  }
  std::map<fs::path, std::string> folders;  // and their names
  std::set<std::string> taken;
  std::map<fs::path, std::string> names;
  for (const fs::path& file : files) {
    const fs::path folder = file.parent_path();
    const std::string plain = folder.filename().string();
    std::string& name = folders.try_emplace(folder).first->second;
    for (int number = 1; name.empty() && !plain.empty(); ++number) {
      const std::string tried = number == 1 ? plain : plain + " (" + std::to_string(number) + ")";
      if (taken.insert(tried).second) name = tried;
    }
    names[file] = (fs::path(name) / file.filename()).generic_string();
  }
  return names;
}

std::map<std::string, Hash> hashes_of_inputs(const Manifest& manifest) {
  std::map<std::string, Hash> hashes;
  for (const InputCopy& copy : input_copies(manifest))
    hashes[copy.path] =
        are_ratings(manifest, copy) ? hash_of(kept_ratings(manifest)) : hash_of_file(copy.source);
  for (const auto& [file, name] : names_of_uncopied_inputs(manifest))
    hashes[name] = hash_of_file(file);
  return hashes;
}

}  // namespace mien::pipeline
