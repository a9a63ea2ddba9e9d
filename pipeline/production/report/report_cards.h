#pragma once

#include <string>

#include "pipeline/manifest/manifest.h"
#include "pipeline/production/report/film_warnings.h"
#include "pipeline/production/synthesis/motions.h"

namespace mien::pipeline {

// Cards of report.html, one per film or sheet. Videos and pictures are linked by paths relative to
// the study's folder.

/// The film of a stimulus, facts about it, warnings, lint errors and requested values; other
/// details are collapsed. Names of parameters are in `language`.
std::string stimulus_card(const Stimulus& stimulus, Motions& motions, NameLanguage language,
                          const FilmWarnings& films);

/// The film of an overlay, its warnings and the list of its motions.
std::string overlay_card(const Overlay& overlay, const Manifest& manifest, const Motions& motions,
                         const FilmWarnings& films);

/// A sheet's picture and its result.
std::string sheet_card(const Sheet& sheet, Motions& motions);

}  // namespace mien::pipeline
