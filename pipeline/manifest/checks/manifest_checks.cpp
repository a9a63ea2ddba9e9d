#include "pipeline/manifest/checks/manifest_checks.h"

#include "pipeline/base/documents/fault_list.h"
#include "pipeline/manifest/checks/examples_checks.h"
#include "pipeline/manifest/checks/film_checks.h"
#include "pipeline/manifest/checks/modification_checks.h"
#include "pipeline/manifest/checks/name_checks.h"
#include "pipeline/manifest/checks/sheet_checks.h"
#include "pipeline/manifest/checks/stimulus_checks.h"

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

/// Where numbers say how large a figure is seen it cannot be made as small as the smallest.
std::vector<Fault> check_equalized_sizes(const Manifest& manifest) {
  FaultList list(manifest.places);
  if (!manifest.equalize.size) return {};
  for (const Stimulus& stimulus : manifest.stimuli) {
    const scenes::CameraSettings& camera = stimulus.look.camera;
    if (!camera.screen && !camera.position && !camera.figure_px && camera.path.empty()) continue;
    list.add("equalize",
             "the camera of \"" + stimulus.id + "\" says already how large its figure is seen",
             "leave size out, or give that camera a view alone");
  }
  return list.take();
}

/// Where numbers say where a camera is, its picture is not moved.
std::vector<Fault> check_equalized_places(const Manifest& manifest) {
  FaultList list(manifest.places);
  if (!manifest.equalize.place) return {};
  for (const Stimulus& stimulus : manifest.stimuli) {
    const scenes::CameraSettings& camera = stimulus.look.camera;
    if (!camera.position && camera.path.empty()) continue;
    list.add("equalize",
             "the camera of \"" + stimulus.id + "\" says already where its figure is seen",
             "leave place out, or give that camera a view");
  }
  return list.take();
}

}  // namespace

std::vector<Fault> check_meaning(const Manifest& manifest) {
  std::vector<Fault> faults = check_examples(manifest);
  append(faults, check_stimuli(manifest));
  append(faults, check_overlays(manifest));
  append(faults, check_sheets(manifest));
  append(faults, check_ids(manifest));
  append(faults, check_films(manifest));
  append(faults, check_equalized_sizes(manifest));
  append(faults, check_equalized_places(manifest));
  append(faults, check_modifications(manifest));
  return faults;
}

}  // namespace mien::pipeline
