#include "pipeline/manifest/checks/part_checks.h"

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "motion/skeleton/body.h"
#include "motion/text/excerpt.h"
#include "pipeline/base/documents/fault.h"
#include "pipeline/base/documents/fault_list.h"
#include "pipeline/base/documents/places.h"
#include "pipeline/manifest/checks/film_checks.h"
#include "pipeline/manifest/look/look_checks.h"
#include "pipeline/manifest/ratings/answers/answer_row.h"
#include "pipeline/manifest/ratings/answers/participant_row.h"
#include "pipeline/manifest/recording_files.h"
#include "scenes/cameras/camera_settings.h"
#include "scenes/point_light/dot_joints.h"

namespace mien::pipeline {

namespace {

std::vector<Fault> check_films(const Manifest& manifest) {
  std::vector<Fault> faults = check_output(manifest.output, "output", manifest.places);
  for (const Stimulus* film : films_of(manifest)) {
    const FilmPaths paths = paths_of(*film);
    append(faults, check_output(film->output, paths.own_output, manifest.places));
    append(faults, check_film(*film, paths, manifest.places));
  }
  return faults;
}

/// Whether the camera fixes the figure's size, which then cannot be equalized.
bool has_own_size(const scenes::CameraSettings& camera) {
  return camera.screen || camera.position || camera.figure_px || !camera.path.empty();
}

/// Whether the camera's position is given, so that its picture is not shifted.
bool has_own_place(const scenes::CameraSettings& camera) {
  return camera.position || !camera.path.empty();
}

std::vector<Fault> check_equalized(const Manifest& manifest, std::optional<EqualizeGroup> group_by,
                                   bool (*is_given)(const scenes::CameraSettings&),
                                   const std::string& what, const std::string& remedy) {
  FaultList list(manifest.places);
  if (!group_by) return {};
  for (const Stimulus& stimulus : manifest.stimuli) {
    if (is_given(stimulus.look.camera))
      list.add(
          "equalize",
          "the camera of \"" + stimulus.id + "\" already determines the " + what + " of its figure",
          remedy);
  }
  return list.take();
}

std::vector<Fault> check_looks(const Manifest& manifest) {
  const std::vector<std::string> joints = scenes::dot_joint_names(motion::standard_body());
  CheckedFiles characters;
  // Where every stimulus has a character of its own, the common figure need not have the face.
  const auto is_character = [](const Stimulus* film) {
    return scenes::file_of(film->look.figure) != nullptr;
  };
  Look common = manifest.look;
  if (scenes::file_of(common.figure) == nullptr &&
      std::ranges::all_of(films_of(manifest), is_character))
    common.face = {};
  std::vector<Fault> faults = check_look(common, "look", manifest.places, joints, characters);
  for (const Stimulus* film : films_of(manifest)) {
    const std::string path = member_path(film->path, "look");
    if (manifest.places.values.contains(path))
      append(faults, check_look(film->look, path, manifest.places, joints, characters));
    for (const Person& person : film->people) {
      const std::string own = member_path(person.motion.path, "look");
      Look look = film->look;
      look.camera = {};  // has been checked
      if (!person.figure && !person.face) continue;
      if (person.figure) look.figure = *person.figure;
      if (person.face) look.face = *person.face;
      append(faults, check_look(look, own, manifest.places, joints, characters));
    }
  }
  return faults;
}

/// Questionnaire and experiments; not checked where their scales or texts are missing.
std::vector<Fault> check_experiments(const ResolvedManifest& resolved) {
  if (!resolved.are_experiments_resolved) return {};
  std::vector<Fault> faults = check_questionnaire(resolved.manifest);
  append(faults, check_matching(resolved.manifest));
  append(faults, check_adaptive(resolved.manifest));
  append(faults, check_languages(resolved.manifest));
  return faults;
}

std::vector<Fault> check_parts(const Manifest& manifest) {
  std::vector<Fault> faults = check_examples(manifest);
  append(faults, check_stimuli(manifest));
  append(faults, check_people(manifest));
  append(faults, check_sounds(manifest));
  append(faults, check_overlays(manifest));
  append(faults, check_sheets(manifest));
  append(faults, check_ids(manifest));
  append(faults, check_films(manifest));
  append(faults, check_equalized(manifest, manifest.equalize.size, has_own_size, "size",
                                 "omit size, or give that camera only a view"));
  append(faults, check_equalized(manifest, manifest.equalize.place, has_own_place, "position",
                                 "omit place, or give that camera a view"));
  append(faults, check_modifications(manifest));
  append(faults, check_design(manifest));
  append(faults, check_licences(manifest));
  return faults;
}

}  // namespace

void check_question_id(const std::string& path, const std::string& id, std::set<std::string>& taken,
                       FaultList& list) {
  if (is_parameter_column(id))
    list.add(path, "names that begin with url_ or jatos_ are reserved for ids of participants",
             "use another name");
  else if (!is_question_column(id))
    list.add(path, "the table of participants has a column with this name", "use another name");
  if (!id.empty() && !taken.insert(id).second)
    list.add(path, motion::in_quotes(id) + " is already the id of another question",
             "give each a different one");
}

std::vector<Fault> check_meaning(const ResolvedManifest& resolved) {
  return merged_faults({check_parts(resolved.manifest), check_looks(resolved.manifest),
                        check_experiments(resolved)});
}

}  // namespace mien::pipeline
