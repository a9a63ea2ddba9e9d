#pragma once

#include <filesystem>

#include "pipeline/production/archive/zip_archive.h"
#include "pipeline/study/matching/experiment/matching_study.h"

namespace mien::pipeline {

/// A matching experiment that runs by itself, the motion core inside the browser: files by their
/// paths, for write_export (questionnaire/experiment/export.h).
///
///     index.html, matching.js, …        what participants open, on disk or on any web server
///     experiment.js, experiment.json    all sessions, for the page and for other programs
///     live_core.js                      the motion core (WebAssembly) and what it blends
///     <study>.jzip                      the same for JATOS
///     plans.csv                         every trial of every participant
///     answers/data/README.md            where the files of participants go
///     README.txt                        for the lab
///
/// `pages` is the folder of the built page, `module` the motion core (live_module()). The same
/// study gives the same bytes.
ZipFiles exported_matching(const Manifest& manifest, const MatchingStudy& study,
                           const std::filesystem::path& pages, const std::filesystem::path& module);

}  // namespace mien::pipeline
