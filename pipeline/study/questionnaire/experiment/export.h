#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "pipeline/manifest/manifest.h"
#include "pipeline/production/archive/zip_archive.h"
#include "pipeline/study/questionnaire/experiment/media.h"
#include "pipeline/study/questionnaire/session_plan.h"

namespace mien::pipeline {

/// A questionnaire that runs without mien's server: files by their paths.
///
///     index.html, questionnaire.js, …   the page for participants, on disk or on any web server
///     experiment.js, experiment.json    all sessions, for the page and for other programs
///     media/<token>.mp4                 media of the stimuli; 3-D clips also as a script
///     <study>.jzip                      page, sessions and media as an archive for JATOS
///     plans.csv                         every trial of every participant
///     answers/dataset_description.json  codebook of the answers (Psych-DS, JSON-LD)
///     answers/data/README.md            instructions to collect the participants' files here
///     README.txt                        instructions for the experimenter
///
/// `pages` is the folder of the built pages (page_bundle). The same study results in the same
/// bytes.
ZipFiles exported_questionnaire(const Manifest& manifest, const std::vector<SessionPlan>& plans,
                                const MediaFiles& media, const std::filesystem::path& pages);

/// Name of the file in an export's folder that lists the export's files, one path per line.
inline constexpr char export_marker[] = ".mien-questionnaire";

/// Throws Error for a folder that is neither empty nor an earlier export, since its files might be
/// overwritten.
void refuse_foreign_folder(const std::filesystem::path& folder);

/// Throws Error if the folder's answers/data contains answers to an earlier export with another
/// design (design_hash), since the answers to both could not be distinguished later.
void refuse_answers_to_other_design(const std::filesystem::path& folder, const std::string& design);

/// Writes the files into the folder, replacing those of an earlier export; answers and other added
/// files stay. Throws Error as refuse_foreign_folder() does.
void write_export(const ZipFiles& files, const std::filesystem::path& folder);

/// Instructions for running an exported questionnaire (README.txt).
std::string export_readme(const Manifest& manifest, const std::vector<SessionPlan>& plans);

/// The codebook of the answers: a Psych-DS dataset_description.json, a Dataset of schema.org in
/// JSON-LD, with every column of answers and participants.
nlohmann::ordered_json dataset_description(const Manifest& manifest);

/// The README of the answers folder.
std::string answers_readme();

}  // namespace mien::pipeline
