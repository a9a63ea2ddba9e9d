#pragma once

#include <string>

#include "pipeline/manifest/manifest.h"
#include "pipeline/production/synthesis/motions.h"

namespace mien::pipeline {

// Cards of report.html, one a film or sheet. Videos and pictures are linked by paths relative to
// the study's folder.

/// The film of a stimulus, what lint found, and what it requested, in the language; what else
/// it has is folded.
std::string stimulus_card(const Stimulus& stimulus, Motions& motions, InterfaceLanguage language);

/// The film of an overlay and which motions are in it.
std::string overlay_card(const Overlay& overlay, const Manifest& manifest, const Motions& motions);

/// A sheet's picture and what it says.
std::string sheet_card(const Sheet& sheet, Motions& motions);

}  // namespace mien::pipeline
