#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "pipeline/base/documents/fault.h"
#include "pipeline/base/documents/fault_list.h"
#include "pipeline/manifest/checks/vocabulary.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/manifest/reading/resolved_manifest.h"
#include "pipeline/manifest/stimulus.h"

namespace mien::pipeline {

/// Returns faults that a schema cannot express: duplicate ids, missing files, sizes that the chosen
/// video formats do not accept, values that need examples or ratings when there are none,
/// comparison sheets of a motion with itself, and contradictory looks and questionnaires. The
/// checks are independent of each other.
std::vector<Fault> check_meaning(const ResolvedManifest& resolved);

/// Returns faults of the examples: a missing folder, missing or inconsistent ratings and scales,
/// inconsistent keytimes, and a `take` although none of the folder's files has a format that can
/// hold several motions.
std::vector<Fault> check_examples(const Manifest& manifest);

/// Returns faults of stimuli: values that need examples or ratings when there are none, values that
/// contradict each other, missing clips, faults of a walker's `path:` (check_walk_path), factors
/// that are not valid column names, options of another interpolation method, and regression
/// tolerances for unknown body parts.
std::vector<Fault> check_stimuli(const Manifest& manifest);

/// Returns faults of stimuli with several people: names that are not unique, motions of their own,
/// people without a place or with one among captured people, and figures and sets that suit one
/// person only.
std::vector<Fault> check_people(const Manifest& manifest);

/// Adds the faults of a stimulus's `path:`, if it has one: unknown moods (but not those of a motion
/// graph, see resolve_modifications), missing motion files, contradictory keys, points that are too
/// close together, and excessive durations.
void check_walk_path(const Stimulus& stimulus, FaultList& list);

/// Returns faults of sounds: files that are missing or of no known format, videos that are not
/// written or cannot have sound, and a gain where loudness is equalized. What a file holds is found
/// when films are made or rehearsed.
std::vector<Fault> check_sounds(const Manifest& manifest);

/// Returns faults of modifications that a schema cannot express: mutually exclusive keys, keys of
/// another method, and poses and styles that need examples or files when there are none.
std::vector<Fault> check_modifications(const Manifest& manifest);

/// Returns a fault for each example that a modification names and that does not exist.
std::vector<Fault> check_modification_names(const Manifest& manifest, const Vocabulary& vocabulary);

/// Returns faults of `design`: unknown factors, and unknown properties that they vary.
std::vector<Fault> check_design(const Manifest& manifest);

/// Return faults of overlays and sheets whose parts are inconsistent.
std::vector<Fault> check_overlays(const Manifest& manifest);
std::vector<Fault> check_sheets(const Manifest& manifest);

/// Returns faults of ids that are duplicate or unsuitable as file names, and of duplicate video
/// names.
std::vector<Fault> check_ids(const Manifest& manifest);

/// Returns faults of adjectives, held parameters, features, weights, expectations, labels,
/// keytimes, overlays and sheets that refer to unknown names. Also refuses grids over too many
/// parameters and expectations that name an example twice.
std::vector<Fault> check_names(const Manifest& manifest, const Vocabulary& vocabulary);

/// Returns faults of a questionnaire that refers to unknown stimuli, scales or factors, has
/// mutually exclusive settings or impossible numbers, or shows stimuli of which there is no
/// suitable file (check_shown_videos). The study's scales must have been read.
std::vector<Fault> check_questionnaire(const Manifest& manifest);

/// Returns faults of the languages of a questionnaire or an experiment: those without texts
/// of pages, and texts, choices and scales that are not given in all languages offered.
std::vector<Fault> check_languages(const Manifest& manifest);

/// Returns faults of the form of a questionnaire's trials: keys that do not apply to it, scales or
/// words that it does not ask, and signals and pairs that do not suit it. No faults without
/// questionnaire.
std::vector<Fault> check_trial_form(const Manifest& manifest);

/// Returns faults of grid trials: unknown, missing or unsuitable sets of stimuli, references and
/// anchors, and keys that do not suit them.
std::vector<Fault> check_grid(const Manifest& manifest);

/// Returns faults of continuous trials: keys and quality rules that do not suit them; otherwise, of
/// a lag of traces that there are not.
std::vector<Fault> check_continuous(const Manifest& manifest);

/// Returns faults of adaptive trials: forms and keys that do not suit them, a factor that is
/// unknown or not numeric, too few levels, and settings of the other method.
std::vector<Fault> check_adaptive_trials(const Manifest& manifest);

/// Returns a single fault for all those stimuli that a questionnaire shows as videos although they
/// are not written in any format that browsers play; none if there are no such stimuli.
std::vector<Fault> check_shown_videos(const Manifest& manifest);

/// Returns a fault if a questionnaire would play two sounds at the same time, or shows figures to
/// be turned, which have no sound. No faults if no stimulus has one.
std::vector<Fault> check_heard_sounds(const Manifest& manifest);

/// Checks the web addresses, codes and URL parameters of a questionnaire's recruitment. No faults
/// if it has none.
std::vector<Fault> check_recruitment(const Manifest& manifest);

/// Checks the answers that a questionnaire's screening accepts and its quotas count. No faults if
/// it has none.
std::vector<Fault> check_screening(const Manifest& manifest);

/// Adds the faults of the id of a question about participants: one of another column of their
/// table, or of another question. `taken` are the ids before; the id is added to them.
void check_question_id(const std::string& path, const std::string& id, std::set<std::string>& taken,
                       FaultList& list);

/// Checks the factors, groups and planned contrasts of a questionnaire's analysis. No faults if it
/// has none.
std::vector<Fault> check_factorial(const Manifest& manifest);

/// Checks the quality rules of a questionnaire's analysis. No faults if it has none.
std::vector<Fault> check_quality(const Manifest& manifest);

/// Returns warnings about quality rules that flag nobody or everybody: rules about raw answers on
/// scales without such answers or with bounds that they cannot reach, and `flagged` without rules.
/// The manifest must have a questionnaire and no faults.
std::vector<Fault> quality_warnings(const Manifest& manifest);

/// The number of stimuli or pairs that are judged in analysed trials; in grid trials, that of the
/// largest sets.
int rated_stimuli_of_session(const Manifest& manifest);

/// Returns warnings about valid but probably unintended settings of a questionnaire: attention
/// checks that can exclude no participant or that never occur, sounds without a test of sound, and
/// those of quality_warnings. The
/// manifest must have no faults.
std::vector<Fault> questionnaire_warnings(const Manifest& manifest);

/// Returns faults of a matching experiment, such as unknown targets, adjectives or features, no
/// targets, or a questionnaire in the same manifest. The study's scales must have been read.
std::vector<Fault> check_matching(const Manifest& manifest);

/// Returns faults of an adaptive experiment, such as unknown dimensions, settings that do not suit
/// its method, too many trials, or a questionnaire in the same manifest. The study's scales must
/// have been read.
std::vector<Fault> check_adaptive(const Manifest& manifest);

/// Returns a fault for each source of motions, looks, ratings, scales or recipes that lies in
/// `folder`, the output folder of the run, which could overwrite it. Its folder `inputs` is
/// excepted: reruns read the copies there.
std::vector<Fault> check_sources(const Manifest& manifest, const std::filesystem::path& folder);

}  // namespace mien::pipeline
