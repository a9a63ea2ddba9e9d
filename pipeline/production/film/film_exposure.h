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

/// Equalizes the mean luminance of a study's films.
///
/// A few small frames of each film are rendered at about draft quality (4 samples per pixel). Their
/// mean luminance as a display shows it, including the tone curve, increases with exposure. For
/// each film there is thus at most one exposure at which its mean luminance has the wanted value.
/// The wanted value is the geometric mean of the films' mean luminances before equalizing: of all
/// films of the study, or of all films with the same kind of figure.
///
/// Point-light figures whose dots are equal in number, size and colour and that are shown on the
/// same set and background share one exposure, at which the mean over all their films has the
/// wanted value; in the geometric mean, each of these films counts with their common mean. With
/// exposures of their own, a scrambled figure, whose dots occlude each other less, would become
/// darker than its original.

extern const TableForm exposure_form;

/// Returns the exposure, −8 … 8 stops added to that of the tone curve, at which the mean luminance
/// of these frames is `wanted`; the nearer limit if there is none.
float stops_for(const std::vector<render::Framebuffer>& films, const render::Tone& tone,
                double wanted);

/// Finds the exposure of each film, stores it in `films` and returns the content of
/// metrics/exposure.csv. Figures have the sizes and positions given in `films`. Throws Faults if no
/// exposure brings a film, or the films that share an exposure, within 1 % of the wanted luminance.
/// Deviations of more than 5 % are detected first, in fewer and smaller frames (faults_in_light).
std::string exposure_csv(const Manifest& manifest, const FilmSettings& settings,
                         FinishedMotions& motions, TaskRun& run, EqualizedFilms& films);

/// Returns a fault for each stimulus whose mean luminance in a few very small frames differs from
/// the wanted one by more than 5 % at every exposure. Smaller deviations are detected only by
/// exposure_csv. Throws Error.
std::vector<Fault> faults_in_light(const Manifest& manifest, FinishedMotions& motions);

}  // namespace mien::pipeline
