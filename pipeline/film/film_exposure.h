#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/film/film.h"
#include "pipeline/synthesis/motions.h"
#include "pipeline/tasks/task_graph.h"
#include "render/image/film.h"
#include "render/image/tone.h"

namespace mien::pipeline {

/// Brings the films of a study to one mean luminance.
///
/// A few small frames of each film are drawn in draft quality. Their mean luminance as a display
/// shows it, tone curve and all, rises with the exposure, so for each film there is one exposure at
/// which it is the geometric mean of all films' means.

/// The stops, −8 … 8, that added to the tone's bring the mean over films of `mean_luminance` to
/// `wanted`; the nearest end where none does.
float stops_for(const std::vector<render::Film>& films, const render::Tone& tone, double wanted);

/// metrics/exposure.csv (film_table_forms.h). Figures are as tall as film_sizes.h found where
/// size is equalized too. Throws Error when an exposure does not bring a film within 1 %.
std::string exposure_csv(const Manifest& manifest, const FilmSettings& settings, Motions& motions,
                         TaskRun& run);

/// What the table has for a stimulus, in the store's folder. Throws Error.
float exposure_stops_of(const std::filesystem::path& folder, const std::string& stimulus);

}  // namespace mien::pipeline
