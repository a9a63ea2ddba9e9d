#pragma once

#include <string>
#include <vector>

#include "pipeline/base/documents/fault.h"
#include "pipeline/base/documents/table.h"
#include "pipeline/production/clips/finished_motions.h"
#include "pipeline/production/film/film.h"
#include "pipeline/production/film/film_equalized.h"
#include "pipeline/tasks/task_graph.h"
#include "render/image/framebuffer.h"
#include "render/image/tone.h"

namespace mien::pipeline {

/// Brings the films of a study to one mean luminance.
///
/// A few small frames of each film are drawn in draft quality. Their mean luminance as a display
/// shows it, tone curve and all, rises with the exposure, so for each film there is one exposure at
/// which it is the geometric mean of the means of all films, or of all with such a figure.
///
/// Point lights with equally many dots of one size and colour on one set share an exposure, at
/// which the mean of all of them is that: a scrambled figure's dots, of which fewer hide each
/// other, would else be darker than those of its original.

extern const TableForm exposure_form;

/// The stops, −8 … 8, that added to the tone's bring the mean over films of `mean_luminance` to
/// `wanted`; the nearest end where none does.
float stops_for(const std::vector<render::Framebuffer>& films, const render::Tone& tone,
                double wanted);

/// Finds the exposure of each film, and returns metrics/exposure.csv. Figures
/// are as tall and stand where `films` has them. Throws Faults when no exposure brings a film, or
/// the films that share one, within 1 %; where it is far from there, after a quick look.
std::string exposure_csv(const Manifest& manifest, const FilmSettings& settings,
                         FinishedMotions& motions, TaskRun& run, EqualizedFilms& films);

/// A fault for each stimulus that no exposure brings near the others' light, as a quick look at
/// small pictures shows; what is out of reach by less than 5 % is left to exposure_csv. Throws
/// Error.
std::vector<Fault> faults_in_light(const Manifest& manifest, FinishedMotions& motions);

}  // namespace mien::pipeline
