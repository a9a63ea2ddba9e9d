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
  nlohmann::ordered_json experiment;  ///< what the page reads (page/src/matching/experiment.ts)
  std::vector<SessionPlan> plans;
  motion::LiveBundle bundle;
};

/// Makes the targets; nothing is drawn. Throws Error when an adjective has no rating, or the
/// examples cannot be blended.
MatchingStudy matching_study(const Manifest& manifest, Motions& motions, int participants = 0);

/// With the pages of that folder (page_bundle("matching")), and motions that the server makes.
ServedStudy served_matching(MatchingStudy study, const std::filesystem::path& pages);

/// The sessions of a matching experiment for all planned participants, or for `count` when that is
/// not 0. A trial is a target (its stimulus) and an interface (its item).
///
/// Practice comes first: its motions one after the other, with the interfaces in the participant's
/// own order, so many trials that each motion and each interface comes. Then one block an
/// interface, in each of which every target comes once. Blocks follow a row of Williams' square of
/// the interfaces (orders.h); targets a row of theirs, another one in each block and for each
/// participant of the same order of blocks.
///
/// Where guesses come first, blocks are targets in that participant's row, in each of which every
/// interface comes once, in another row of theirs in each block; so practice has every motion with
/// every interface. Every plan is a pure function of (manifest, its index).
std::vector<SessionPlan> plan_matching(const Manifest& manifest, int count = 0);

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

/// Simulated trials. In each plan, practice excluded, a simulated user
/// (simulated_trial.h) before each target, who takes 20 s to guess and 3 s for each look after it,
/// and gives up at the limit. Sliders are those that are shown at once. Every trial is marked as
/// simulated. Where a target is no blend, its sliders are read as being in the middle.
std::vector<MatchedTrial> simulated_matching(const Manifest& manifest, Motions& motions,
                                             const MatchingStudy& study);

/// Distance between a target and the motion at the initial slider settings.
struct StartingDistance {
  std::string target;
  std::string interface;
  double metres = 0.0;  ///< D
};

/// Starting distances of each target except practice with each interface. Sliders are at their
/// initial positions on the page: the examples' mean, or weights of 0.
std::vector<StartingDistance> starting_distances(const Manifest& manifest,
                                                 const MatchingStudy& study);

/// A threshold below the usual starting distances, metres: the paper's 0.06, or half of the median
/// starting distance, rounded down to a millimetre, where that is less.
double suggested_threshold(const std::vector<StartingDistance>& distances);

/// A warning about trials that match before any slider is moved; empty where there are none.
std::string starting_match_warning(const Manifest& manifest, const MatchingStudy& study);

}  // namespace mien::pipeline
