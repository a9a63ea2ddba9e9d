#pragma once

#include <span>
#include <string>
#include <vector>

#include "pipeline/manifest/manifest.h"
#include "pipeline/production/report/report_parts.h"
#include "pipeline/production/synthesis/motions.h"

namespace mien::pipeline {

// Sections of the report, each with a title; empty if there is no content.

std::string titled_section(const std::string& title, const std::string& content);

/// Cards of some of the manifest's stimuli, and the aspects in which the foils among them differ.
std::string stimuli_section(const std::string& title, std::span<const Stimulus> stimuli,
                            const Manifest& manifest, Motions& motions);

std::string overlays_section(const std::string& title, std::span<const Overlay> overlays,
                             const Manifest& manifest, Motions& motions);

/// The stimuli with findings or warnings, their numbers, and the first error of each; empty if
/// there are none.
std::string findings_section(const Manifest& manifest, Motions& motions);

/// The sheets of stills.
std::string stills_section(const Manifest& manifest, Motions& motions);

/// The results of comparisons, then the sheets.
std::string comparisons_section(const std::string& title, std::span<const Sheet* const> sheets,
                                Motions& motions);

/// Links to the pages of a study that is split into parts, and to all stimuli on them.
std::string parts_section(const std::vector<ReportPart>& parts, const Manifest& manifest);

}  // namespace mien::pipeline
