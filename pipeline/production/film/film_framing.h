#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "pipeline/base/documents/csv.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/production/clips/finished_motions.h"
#include "pipeline/production/film/film_shot.h"
#include "pipeline/tasks/task_graph.h"

namespace mien::pipeline {

/// metrics/sizes.csv (film_table_forms.h).
std::string sizes_csv(const Manifest& manifest, FinishedMotions& motions, TaskRun& run);

/// metrics/places.csv (film_table_forms.h): the mean of the places that the cameras show, moved as
/// far as it must be for every figure to stay within its picture that was within it before. Figures
/// are as tall as metrics/sizes.csv says where size is equalized too. Throws Error where no place
/// is left.
std::string places_csv(const Manifest& manifest, FinishedMotions& motions, TaskRun& run);

/// Throws Error where `places_csv` would find no place.
void check_places(const Manifest& manifest, FinishedMotions& motions);

/// What the tables that `equalize` asks for have for all stimuli, in the store's folder. Throws
/// Error.
class Framings {
 public:
  Framings(const Equalize& equalize, const std::filesystem::path& folder);

  Framing of(const std::string& stimulus) const;

 private:
  std::optional<StimulusNumbers> sizes_;
  std::optional<StimulusNumbers> places_;
};

/// The same for one stimulus.
Framing equalized_framing(const Equalize& equalize, const std::filesystem::path& folder,
                          const std::string& stimulus);

}  // namespace mien::pipeline
