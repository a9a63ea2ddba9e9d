#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/manifest/manifest.h"
#include "pipeline/manifest/ratings/answers/answer_row.h"
#include "pipeline/production/archive/zip_archive.h"
#include "pipeline/study/questionnaire/session_plan.h"

namespace mien::pipeline {

/// A media file of the questionnaire.
struct ShownMedia {
  std::string stimulus;
  std::string path;  ///< in the study's folder: "videos/walk.mp4", "clips/walk.glb"
};

/// The media of all stimuli that a questionnaire shows (shown_stimuli): their videos in all formats
/// and, if participants may rotate the view, also their 3-D motions.
std::vector<ShownMedia> shown_media(const Manifest& manifest);

/// A snapshot of a questionnaire's design for preregistration:
///
///     README.txt           description of the bundle
///     design.json          study, hash of the design, participants, expected duration, analysis
///     plans.csv            every trial of every participant
///     balance.csv          counts that show the balance of the plans
///     scales.csv           scales, with both ends
///     analysis-plan.txt    the preregistered analysis plan, as stated in the manifest, and its
///                          quality rules in words
///     stimuli.csv          stimulus, file and SHA-256 of all media
///     inputs/…             the manifest and the files of texts, scales, recipes and scenery
///                          (`scene:`) that it names
///     inputs.csv           hashes of these files and of the motions that they name
///     dummy-report/…       a report on simulated answers
///     manifest-sha256.txt  hashes of all other files
///
/// The dummy report is added later, by add_dummy_answers and add_folder. The bundle contains no
/// dates, so that the same study results in the same bytes. `study_folder` is the output folder of
/// the study. Throws Error if the media of a stimulus are missing.
ZipFiles frozen_design(const Manifest& manifest, const std::vector<SessionPlan>& plans,
                       const std::filesystem::path& study_folder);

/// Adds all files below a folder to `frozen`, as `prefix`/…, and updates the list of hashes. Throws
/// Error for entries that are neither files nor folders.
void add_folder(ZipFiles& frozen, const std::filesystem::path& folder, const std::string& prefix);

/// Simulated answers of participants who pass every attention check; the true ratings of all
/// stimuli are in the middle of the scale. In emotion trials, the intended emotion is recognised at
/// the usual rate (SimulatedParticipants).
std::vector<AnswerRow> dummy_answers(const Manifest& manifest,
                                     const std::vector<SessionPlan>& plans);

/// What the dummy answers assume, in sentences, ended by a line end: that stimuli have no effect,
/// how answers vary, and what is recognised.
std::string dummy_assumptions(const Manifest& manifest);

/// Adds the dummy answers (dummy-report/answers.csv) and, if participants are asked about
/// themselves, a table of them (dummy-report/participants.csv), so that the analysis can be tested
/// before data collection.
void add_dummy_answers(ZipFiles& frozen, const Manifest& manifest,
                       const std::vector<SessionPlan>& plans);

/// Compares a study with a frozen bundle. Returns sentences that describe the differences; empty if
/// there are none. Each sentence begins with what differs, such as design, participants, plans of
/// participants, scales, analysis, inputs or stimuli. If `study_folder` is empty, media are not
/// compared, and a sentence states that.
///
/// Throws Error if `bundle` is not a frozen bundle or its hashes do not match, and if media are
/// missing in `study_folder`.
std::vector<std::string> frozen_differences(const std::filesystem::path& bundle,
                                            const Manifest& manifest,
                                            const std::filesystem::path& study_folder = {});

}  // namespace mien::pipeline
