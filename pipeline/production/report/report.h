#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "pipeline/manifest/manifest.h"
#include "pipeline/production/design/design_findings.h"
#include "pipeline/production/methods/methods.h"
#include "pipeline/production/report/film_warnings.h"
#include "pipeline/production/report/report_parts.h"
#include "pipeline/production/synthesis/motions.h"

namespace mien::pipeline {

/// Returns report.html: the whole study on one page that works from disk without a network. Videos,
/// contact sheets and comparison sheets are linked by paths relative to the study's folder; styles
/// are inline. For a large study (report_parts.h), the page contains only the common parts and
/// links to the other pages. `films` are the warnings about the films.
std::string report(const Manifest& manifest, Motions& motions, const Methods& methods,
                   const DesignFindings& design, const FilmWarnings& films = {});

/// Returns the page of one of the study's parts.
std::string report_part(const std::vector<ReportPart>& parts, std::size_t which,
                        const Manifest& manifest, Motions& motions, const FilmWarnings& films = {});

}  // namespace mien::pipeline
