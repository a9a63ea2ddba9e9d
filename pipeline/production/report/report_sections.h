#pragma once

#include <span>
#include <string>
#include <vector>

#include "pipeline/manifest/manifest.h"
#include "pipeline/production/report/film_warnings.h"
#include "pipeline/production/report/report_parts.h"
#include "pipeline/production/synthesis/motions.h"

namespace mien::pipeline {

// Sections of the report, each with a title; empty if there is no content.

std::string titled_section(const std::string& title, const std::string& content);

/// Cards of some of the manifest's stimuli, the properties equalized across the study, and the
/// table of the foils among these stimuli (foil_table).
std::string stimuli_section(const std::string& title, std::span<const Stimulus> stimuli,
                            const Manifest& manifest, Motions& motions, const FilmWarnings& films);

std::string overlays_section(const std::string& title, std::span<const Overlay> overlays,
                             const Manifest& manifest, Motions& motions, const FilmWarnings& films);

/// Every motion and every film with findings or warnings: the number of errors, the number of
/// warnings, and the first error or, if it has no error, the first warning. Empty without any.
std::string findings_section(const Manifest& manifest, Motions& motions, const FilmWarnings& films);

/// The sheets of stills.
std::string stills_section(const Manifest& manifest, Motions& motions);

/// The results of these comparisons in tables, then the sheets themselves.
std::string comparisons_section(const std::string& title, std::span<const Sheet* const> sheets,
                                Motions& motions);

/// Links to the pages of a study that is split into parts, and to all stimuli on them; also the
/// properties equalized across the study.
std::string parts_section(const std::vector<ReportPart>& parts, const Manifest& manifest);

}  // namespace mien::pipeline
