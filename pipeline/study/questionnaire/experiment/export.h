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

/// A questionnaire that runs by itself: files by their paths.
///
///     index.html, questionnaire.js, …   what participants open, on disk or on any web server
///     experiment.js, experiment.json    all sessions, for the page and for other programs
///     media/<token>.mp4                 what is shown; a clip is there as a script, too
///     <study>.jzip                      the same for JATOS
///     plans.csv                         every trial of every participant
///     answers/dataset_description.json  what the columns of the answers mean (Psych-DS, JSON-LD)
///     answers/data/README.md            where the answers of participants go
///     README.txt                        for the lab
///
/// `pages` is the folder of the built pages (page_bundle). The same study gives the same bytes.
ZipFiles exported_questionnaire(const Manifest& manifest, const std::vector<SessionPlan>& plans,
                                const MediaFiles& media, const std::filesystem::path& pages);

/// In a folder that holds an exported questionnaire: the paths of its files, one a line.
inline constexpr char export_mark[] = ".mien-questionnaire";

/// Throws Error for a folder that holds anything else than an exported questionnaire and what was
/// added to it: it might be written over.
void refuse_foreign_folder(const std::filesystem::path& folder);

/// Throws Error where the folder's answers/data holds answers and what was exported there had
/// another design (design_hash): nobody could tell later which of them were given to which.
void refuse_answers_to_another(const std::filesystem::path& folder, const std::string& design);

/// Puts the files into the folder in the place of those of an earlier export; answers and whatever
/// else was added there stay.
void write_export(const ZipFiles& files, const std::filesystem::path& folder);

/// What a lab must know to run an exported questionnaire.
std::string lab_text(const Manifest& manifest, const std::vector<SessionPlan>& plans);

/// The codebook of the answers: a Psych-DS dataset_description.json, a Dataset of schema.org in
/// JSON-LD, with every column of answers and participants.
nlohmann::ordered_json dataset_description(const Manifest& manifest);

/// What stands in the folder that answers are put into.
std::string data_folder_text();

}  // namespace mien::pipeline
