#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "pipeline/manifest/manifest.h"
#include "pipeline/production/archive/zip_archive.h"
#include "pipeline/study/live/live_bundle_writer.h"
#include "pipeline/study/questionnaire/service/matching_rows.h"
#include "pipeline/study/questionnaire/service/served_study.h"
#include "pipeline/study/questionnaire/session_plan.h"

namespace mien::pipeline {

/// A matching experiment, ready to be served, exported or simulated.
struct MatchingStudy {
  nlohmann::ordered_json
      experiment;  ///< content of experiment.json (page/src/matching/experiment.ts)
  std::vector<SessionPlan> plans;
  motion::LiveBundle bundle;
};

/// Plans the sessions of `participants` participants (0: the number in the manifest) and
/// synthesizes the target motions without rendering them. Throws Error if an adjective has no
/// rating or the examples cannot be blended.
MatchingStudy matching_study(const Manifest& manifest, Motions& motions, int participants = 0);

/// The study as a server serves it, with the pages in the folder `pages` (page_bundle("matching")).
/// The server synthesizes the motions.
ServedStudy served_matching(MatchingStudy study, const std::filesystem::path& pages);

/// The sessions of a matching experiment for `count` participants, or for all planned ones if
/// `count` is 0. A trial is a target (its stimulus) and an interface (its item).
///
/// A session begins with practice, which cycles through the practice motions and through the
/// interfaces in the participant's order, until each practice motion and each interface has
/// occurred. One block per interface follows, which contains every target once. The blocks are
/// ordered by a row of Williams' square of the interfaces (williams_row), the targets within a
/// block by a row of the square of the targets. Each further block uses the next row, and so does
/// the next participant with the same order of blocks.
///
/// With MatchingOrder::guesses_first, there is one block per target instead, ordered by a row of
/// the square of the targets. Each block contains every interface once, ordered by a row of the
/// square of the interfaces; the next block uses the next row. Practice has one such block per
/// practice motion. Every plan is a pure function of (manifest, index).
std::vector<SessionPlan> plan_matching(const Manifest& manifest, int count = 0);

/// A matching experiment that runs without a server, with the files of exported_live
/// (questionnaire/experiment/live_export.h). `pages` is the folder of the built page, `module` the
/// live core (live_module()). The same study results in the same bytes.
ZipFiles exported_matching(const Manifest& manifest, const MatchingStudy& study,
                           const std::filesystem::path& pages, const std::filesystem::path& module);

/// Simulates all trials of all plans except practice, with one simulated user (simulated_trial.h)
/// per trial, who needs 20 s for the first guess, then 3 s for each further view, and stops at the
/// time limit, which is counted from the first guess. The user has the sliders that the page shows
/// initially. For a target that is not a blend, the ideal slider settings are taken as 0.5. Every
/// trial is marked as simulated.
std::vector<MatchedTrial> simulated_matching(const Manifest& manifest, Motions& motions,
                                             const MatchingStudy& study);

/// Distance between a target and the motion at the initial slider settings.
struct StartingDistance {
  std::string target;
  std::string interface;
  double metres = 0.0;  ///< D
};

/// Starting distances of all targets except those of practice, with each interface. Sliders are at
/// their initial positions on the page: the examples' mean, rounded to 0.01, for parameters, and 0
/// for weights.
std::vector<StartingDistance> starting_distances(const Manifest& manifest,
                                                 const MatchingStudy& study);

/// Suggested threshold of D below which motions match, metres: half of the median starting
/// distance, rounded down to a millimetre, but at most 0.06 (the paper's threshold) and at least
/// 0.001. Without distances, 0.06.
double suggested_threshold(const std::vector<StartingDistance>& distances);

/// A warning about targets that match before any slider is moved; empty if no target does.
std::string starting_match_warning(const Manifest& manifest, const MatchingStudy& study);

}  // namespace mien::pipeline
