#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "pipeline/manifest/manifest.h"
#include "pipeline/production/archive/zip_archive.h"
#include "pipeline/study/questionnaire/session_plan.h"

namespace mien::pipeline {

/// An experiment whose page synthesizes motions in the browser, to be exported.
struct LiveExport {
  std::string page;             ///< name of its page: "matching"
  std::filesystem::path pages;  ///< folder of the built page
  std::string experiment_name;  ///< "Matching experiment"
  std::string live_script;      ///< live core and bundle (study/live/live_script.h)
  std::string saved_files;      ///< files that the browser saves, as README.txt lists them
  std::string trials_file;      ///< "trials"
  std::string analysis;         ///< paragraph of README.txt on the analysis
  Phones phones = Phones::refused;
};

/// The files of an experiment that runs without a server, by their paths, for write_export
/// (export.h).
///
///     index.html, <page>.js, …          the page for participants, on disk or on any web server
///     experiment.js, experiment.json    all sessions, for the page and for other programs
///     live_core.js                      the live core (WebAssembly) and the live bundle
///     <study>.jzip                      page, sessions and live core as an archive for JATOS
///     plans.csv                         every trial of every participant
///     answers/data/README.md            instructions to collect the participants' files here
///     README.txt                        instructions for the experimenter
///
/// The same arguments result in the same bytes. `plans` must not be empty.
ZipFiles exported_live(const LiveExport& what, const Manifest& manifest,
                       const nlohmann::ordered_json& experiment,
                       const std::vector<SessionPlan>& plans);

}  // namespace mien::pipeline
