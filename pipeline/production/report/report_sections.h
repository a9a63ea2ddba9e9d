#pragma once

#include <span>
#include <string>
#include <vector>

#include "pipeline/manifest/manifest.h"
#include "pipeline/production/report/report_parts.h"
#include "pipeline/production/synthesis/motions.h"

namespace mien::pipeline {

// Sections of the report, each with a title; empty where there is nothing to show.

std::string titled_section(const std::string& title, const std::string& content);

/// Cards of some of the manifest's stimuli, and what those among them that are foils differ in.
std::string stimuli_section(const std::string& title, std::span<const Stimulus> stimuli,
                            const Manifest& manifest, Motions& motions);

std::string overlays_section(const std::string& title, std::span<const Overlay> overlays,
                             const Manifest& manifest, Motions& motions);

/// Which stimuli have findings or warnings, how many, and the first error of each; empty without
/// any.
std::string findings_section(const Manifest& manifest, Motions& motions);

/// Pages of stills.
std::string stills_section(const Manifest& manifest, Motions& motions);

/// What comparisons found, then the sheets.
std::string comparisons_section(const std::string& title, std::span<const Sheet* const> sheets,
                                Motions& motions);

/// Links to the pages of a study that is cut into parts, and to all stimuli on them.
std::string parts_section(const std::vector<ReportPart>& parts, const Manifest& manifest);

}  // namespace mien::pipeline
