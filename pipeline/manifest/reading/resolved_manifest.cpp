#include "pipeline/manifest/reading/resolved_manifest.h"

#include <algorithm>
#include <system_error>
#include <type_traits>
#include <utility>

#include "motion/formats/keypoints/keypoint_frames.h"
#include "motion/text/file_contents.h"
#include "pipeline/base/documents/fault_list.h"
#include "pipeline/base/documents/utf8.h"
#include "pipeline/base/reading/field_reader.h"
#include "pipeline/manifest/foil.h"
#include "pipeline/manifest/hold.h"
#include "pipeline/manifest/look/look_checks.h"
#include "pipeline/manifest/look/point_form.h"
#include "pipeline/manifest/people.h"
#include "pipeline/manifest/reading/recipes.h"
#include "pipeline/manifest/study_texts.h"
#include "pipeline/manifest/texts/page_texts.h"

namespace mien::pipeline {

namespace {

using nlohmann::json;

/// A look that says nothing of its own has the manifest's.
std::vector<Fault> resolve_sets(Manifest& manifest) {
  ReadSets sets;
  std::vector<Fault> faults = resolve_set(manifest.look, "look", manifest.places, sets);
  const auto resolve_film = [&](Stimulus& film) {
    const std::string path = member_path(film.path, "look");
    if (manifest.places.values.contains(path)) {
      append(faults, resolve_set(film.look, path, manifest.places, sets));
    } else {
      film.look.set = manifest.look.set;
    }
  };
  for (Stimulus& stimulus : manifest.stimuli) {
    resolve_film(stimulus);
    for (Person& person : stimulus.people) person.motion.look.set = stimulus.look.set;
  }
  for (Overlay& overlay : manifest.overlays) resolve_film(overlay.film);
  return faults;
}

std::vector<Fault> resolve_scales(ScalesSource& scales) {
  if (!motion::read_error(scales.file, motion::max_document_bytes).empty()) return {};
  try {
    scales = scales_in(scales.file);
  } catch (const Faults& wrong) {
    return wrong.list();
  } catch (const Error& wrong) {
    return {{{}, "examples.scales", wrong.what(), ""}};
  }
  return {};
}

/// Reads a text for participants, where it is in a file.
void resolve_text(const std::string& path, auto& source, FaultList& list) {
  if (source.file.empty()) return;
  const std::string at = member_path(path, "file");
  const motion::FileReading read = motion::bytes_of_file(source.file, motion::max_document_bytes);
  if (!read.bytes) {
    list.check_file(at, source.file, "a text file", motion::max_document_bytes);
  } else if (first_invalid_utf8(*read.bytes)) {
    list.add(at, source.file.string() + " is not UTF-8", "save it as UTF-8");
  } else {
    source.text = *read.bytes;
  }
}

/// Reads the texts for participants of a questionnaire or an experiment.
void resolve_texts(auto& experiment, FaultList& list) {
  visit_texts(experiment, [&list](const std::string& path, auto& text) {
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(text)>, TextSource>) {
      resolve_text(path, text, list);
      for (auto& [language, translated] : text.by_language)
        resolve_text(member_path(path, language), translated, list);
    }
  });
}

/// Reads the files of a study's own texts of pages.
std::vector<Fault> resolve_own_texts(const std::string& path, OwnTexts& own, const Places& places) {
  std::vector<Fault> faults;
  own.texts.clear();
  for (std::size_t i = 0; i < own.files.size(); ++i) {
    FaultList list(places);
    list.check_file(own.files.size() == 1 ? path : element_path(path, i), own.files[i],
                    "a file of texts (YAML)", motion::max_document_bytes);
    std::vector<Fault> missing = list.take();
    if (!missing.empty()) {
      append(faults, std::move(missing));
      continue;
    }
    try {
      own.texts.push_back(read_texts(own.files[i]));
    } catch (const Faults& wrong) {
      append(faults, wrong.list());
    }
  }
  return faults;
}

std::vector<Fault> resolve_own_scales(ScaleChoice& scales, const Places& places) {
  if (scales.file.empty()) return {};
  FaultList list(places);
  list.check_file("questionnaire.scales.file", scales.file, "a scales file (YAML)",
                  motion::max_document_bytes);
  std::vector<Fault> faults = list.take();
  if (!faults.empty()) return faults;
  try {
    scales.own = read_scales(scales.file);
  } catch (const Faults& wrong) {
    return wrong.list();
  }
  return {};
}

std::vector<Fault> resolve_experiments(Manifest& manifest) {
  FaultList list(manifest.places);
  visit_experiments(manifest, [&list](auto& experiment) { resolve_texts(experiment, list); });
  choose_first_language(manifest);
  if (manifest.questionnaire)
    resolve_text("questionnaire.analysis.plan", manifest.questionnaire->analysis.plan, list);
  std::vector<Fault> faults = list.take();
  if (manifest.matching)
    append(faults, resolve_own_texts("matching.texts", manifest.matching->texts, manifest.places));
  if (manifest.adaptive)
    append(faults, resolve_own_texts("adaptive.texts", manifest.adaptive->texts, manifest.places));
  if (!manifest.questionnaire) return faults;
  Questionnaire& experiment = *manifest.questionnaire;
  append(faults, resolve_own_texts("questionnaire.texts", experiment.texts, manifest.places));
  append(faults, resolve_own_scales(experiment.scales, manifest.places));
  return faults;
}

/// Built-in sets that are blended come with ratings.
void add_builtin_ratings(const json& document, Manifest& manifest) {
  const json* examples = member(document, "examples");
  if (examples == nullptr || member(*examples, "ratings") != nullptr) return;
  if (manifest.examples.builtin.empty() || !manifest.examples.blendable) return;
  manifest.ratings.source = Ratings::Source::builtin;
}

void set_paths(Manifest& manifest) {
  for (std::size_t i = 0; i < manifest.stimuli.size(); ++i)
    manifest.stimuli[i].path = element_path("stimuli", i);
  for (std::size_t i = 0; i < manifest.overlays.size(); ++i)
    manifest.overlays[i].film.path = element_path("overlays", i);
  for (std::size_t i = 0; i < manifest.sheets.size(); ++i)
    manifest.sheets[i].path = element_path("sheets", i);
}

std::string default_id(const Sheet& sheet) {
  return !sheet.stills.empty()    ? "stills"
         : !sheet.gallery.empty() ? "gallery"
                                  : sheet.target + "_" + sheet.created;
}

void set_default_ids(Manifest& manifest) {
  for (Overlay& overlay : manifest.overlays) {
    if (overlay.film.id.empty()) overlay.film.id = overlay.target + "_with_" + overlay.created;
  }
  for (Sheet& sheet : manifest.sheets) {
    if (sheet.id.empty()) sheet.id = default_id(sheet);
  }
}

/// A folder of a single recording's frames stands for its first frame, of which all files are read.
void resolve_frame_folder(std::filesystem::path& file) {
  std::error_code unknown;
  if (!std::filesystem::is_directory(file, unknown)) return;
  const std::vector<std::filesystem::path> recordings = motion::keypoint_recordings(file);
  if (recordings.size() == 1) file = recordings.front();
}

void resolve_frame_folders(Manifest& manifest) {
  visit_motion_sources(manifest, [](Stimulus& stimulus) {
    if (stimulus.clip) resolve_frame_folder(stimulus.clip->file);
    if (!stimulus.walk) return;
    for (GraphMotion& motion : stimulus.walk->graph) resolve_frame_folder(motion.file);
  });
}

}  // namespace

ResolvedManifest resolve(Manifest manifest) {
  resolve_frame_folders(manifest);
  std::vector<Fault> faults = resolve_modifications(manifest);
  append(faults, resolve_foils(manifest));
  append(faults, resolve_swaps(manifest));
  append(faults, resolve_sounds(manifest));
  resolve_holds(manifest);
  append(faults, resolve_sets(manifest));
  std::vector<Fault> experiment_faults = resolve_scales(manifest.scales);
  append(experiment_faults, resolve_experiments(manifest));
  const bool are_experiments_resolved = experiment_faults.empty();
  append(faults, std::move(experiment_faults));
  return {std::move(manifest), std::move(faults), are_experiments_resolved};
}

Manifest build_manifest(JsonReading reading, const std::filesystem::path& file,
                        const PathVisitor& names) {
  Manifest manifest;
  manifest.file = file;
  manifest.places = std::move(reading.places);
  manifest.renamed = std::move(reading.renamed);
  const auto resolve = [&names, folder = file.parent_path()](const std::string& path) {
    std::filesystem::path resolved = (folder / path).lexically_normal();
    if (names) names(path, resolved);
    return resolved;
  };
  const ReadingContext context{manifest.places, resolve};
  read({reading.document, "", context}, manifest);
  manifest.interpolation.weights.nearest.seed = manifest.seed;
  add_builtin_ratings(reading.document, manifest);
  set_paths(manifest);
  set_default_ids(manifest);
  name_people(manifest);
  return manifest;
}

}  // namespace mien::pipeline
