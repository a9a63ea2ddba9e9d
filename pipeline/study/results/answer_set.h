#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "pipeline/manifest/factor_crossing.h"
#include "pipeline/manifest/factorial_plan.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/manifest/questionnaire_grid.h"
#include "pipeline/manifest/ratings/answers/answer_row.h"
#include "pipeline/manifest/ratings/answers/counted_answers.h"
#include "pipeline/manifest/ratings/scales/scales.h"
#include "pipeline/study/results/quality_flags.h"
#include "pipeline/study/results/repeated_participation.h"
#include "pipeline/study/thresholds/track_procedure.h"

namespace mien::pipeline {

/// A stimulus with its factors, for use in results.
struct ReportedStimulus {
  std::string id;
  std::string made;     ///< level of the factor `made` (how the motion was produced): acted,
                        ///< modified, as-is …; may be empty
  std::string emotion;  ///< level of the factor `emotion`; may be empty
  /// Levels of all other factors of the manifest except `strength`, `example` and `clip`: "woman,
  /// walk". Most comparisons are between stimuli of the same setting.
  std::string setting;
  Factors factors;
  /// Of continuous trials: the moods of a stimulus whose mood changes while it is seen, by time of
  /// its video; empty otherwise.
  std::vector<ShownMood> moods = {};
  double film_s = 0.0;  ///< of continuous trials: duration of the film; 0 if unknown

  /// Whether the stimulus is the baseline of others: its emotion is neutral or normal, or it has no
  /// emotion and `made` is as-is or neutral.
  bool is_neutral() const;
};

/// A rating included in the analysis. Indices refer to AnswerSet.
struct AnalysedRating {
  std::size_t person = 0;
  std::size_t stimulus = 0;
  std::size_t scale = 0;
  double value = 0.0;  ///< in the scale's own range
};

/// The trace of a continuous trial. Indices refer to AnswerSet; its mean after the lead is also an
/// AnalysedRating.
struct AnalysedTrace {
  std::size_t person = 0;
  std::size_t stimulus = 0;
  std::size_t scale = 0;
  std::vector<double> values;  ///< 0 to 100, towards the high end, as sampled (trace.h)
};

/// A forced choice of the emotion of a stimulus.
struct AnalysedChoice {
  std::size_t person = 0;
  std::size_t stimulus = 0;
  std::string chosen;
};

/// A choice between two stimuli, or one that the answer about a set implies.
struct AnalysedPreference {
  std::size_t person = 0;
  std::size_t chosen = 0;  ///< of a tie, the one on the left
  std::size_t other = 0;
  std::string item;
  bool is_left_chosen = true;  ///< whether `chosen` was shown on the left
  bool is_tie = false;
};

/// An answer to a trial of detection or to a same–different trial (DetectionCounts).
struct AnalysedDetection {
  std::size_t person = 0;
  std::size_t stimulus = 0;  ///< of a pair, the one that is earlier in the manifest
  std::optional<std::size_t> other = std::nullopt;  ///< of a pair of two different stimuli
  bool is_signal = false;                           ///< whether it is a signal trial
  bool is_positive = false;                         ///< answered with yes, first or different
};

/// An answer to an adaptive trial.
struct AnalysedLevel {
  std::size_t person = 0;
  int trial = 0;          ///< number in the session
  int track = 0;          ///< from 1; 0: without the signal, not of a track
  double level = 0.0;     ///< of the factor, as stated in the manifest
  std::size_t place = 0;  ///< of a track: the place of the level in the grid
  bool is_positive = false;
  /// Whether quality rules permit to count it. Levels follow from all answers.
  bool is_counted = true;
};

/// How thresholds are determined from the answers to adaptive trials.
struct ThresholdDesign {
  std::string factor;
  double sign = 1.0;        ///< level = sign · ease: −1 if lower levels are easier
  double proportion = 0.0;  ///< of positive answers at the threshold
  TrackProcedure procedure;
};

/// An answer about a set of stimuli: which is best and which is worst with respect to a scale.
struct AnalysedSet {
  std::size_t person = 0;
  std::vector<std::size_t> stimuli;  ///< from left to right
  std::string scale;                 ///< id
  std::size_t best = 0;              ///< index into `stimuli`
  std::size_t worst = 0;             ///< index into `stimuli`
};

/// A free text: a comment, or an answer in words to the scale `item`.
struct Remark {
  std::string participant;
  std::string stimulus;
  std::string item;
  std::string text;
};

/// Options of the analysis that override the manifest.
struct ReportChoices {
  std::optional<TestCorrection> correction;
  std::optional<int> max_failed_checks;
  std::map<std::uint64_t, int>
      planned;  ///< planned number of trials of a session, by the seed of its plan
  std::set<std::string> finished;   ///< participants who finished (ParticipantTable::finished)
  bool without_unfinished = false;  ///< exclude participants who did not finish
  SessionPeople session_people;     ///< for the quality rule repeated_by
  /// Of continuous trials: the moods of stimuli whose mood changes, by stimulus id.
  std::map<std::string, std::vector<ShownMood>> moods = {};
  /// Of continuous trials: durations of the films, by stimulus id.
  std::map<std::string, double> film_seconds = {};
};

/// A participant who answered fewer trials than planned and is not among `finished`
/// (ReportChoices).
struct Unfinished {
  std::string participant;
  int trials = 0;   ///< number of answered trials
  int planned = 0;  ///< number of trials in the session plan
};

/// The validated answers of a questionnaire, the basis of all statistics.
struct AnswerSet {
  std::string study;
  std::string title;
  const TrialForm* form = &rating_form;  ///< form of the questionnaire's trials
  std::vector<std::string> people;       ///< included participants
  std::vector<ReportedStimulus> stimuli;
  /// The levels of the design's factors for each of `stimuli` (design_table).
  FactorTable factors;
  FactorialPlan factorial;  ///< as stated in the manifest
  std::vector<Scale> scales;
  std::vector<std::pair<std::string, std::string>>
      choices;             ///< choices of emotion trials: id, label
  bool is_slider = false;  ///< scales are answered by sliders
  int points = 5;          ///< number of points of a scale; a slider is divided into 11 points
  std::vector<AnalysedRating> ratings;
  std::vector<AnalysedTrace> traces;  ///< of continuous trials
  double trace_lead_s = 0.0;          ///< seconds of the film that means of traces leave out
  double trace_lag_s = 0.0;           ///< seconds by which traces are moved back
  std::vector<AnalysedChoice> chosen;
  std::vector<AnalysedPreference> preferences;
  std::vector<AnalysedDetection> detections;
  std::vector<AnalysedLevel> levels;          ///< of adaptive trials, in the order of the rows
  std::optional<ThresholdDesign> thresholds;  ///< with adaptive trials only
  std::vector<AnalysedSet> sets;
  std::vector<GridSet> grid;         ///< the sets of grid trials
  std::vector<Remark> remarks;       ///< comments
  std::vector<Remark> words;         ///< answers to scales answered in words
  std::vector<Attention> attention;  ///< results of attention checks, of all participants
  AttentionRule rule;
  QualityFlags quality;  ///< flags of answers, by index of the rows as read, and of participants
  std::vector<Unfinished> unfinished;
  /// Whether it is known which participants took part repeatedly, if a quality rule asks for it.
  bool is_repetition_known = true;
  bool without_unfinished = false;
  std::set<std::string>
      worded_questions;  ///< ids of demographic questions whose answers are not numbers
  TestCorrection correction = TestCorrection::holm;
  double alpha = 0.05;  ///< significance level
  bool simulated = false;
  std::string design;  ///< design hash of the answers; may be empty
  /// Who gave the answers of each session: the session as tables name it, and the participant as in
  /// `people` (separate_participants), also if excluded.
  std::map<SessionName, std::string> person_of_session;
  /// A sentence for each participant id that was split, because several sessions used it
  /// (separate_participants), and about a quality rule that could not be applied.
  std::vector<std::string> notes;
};

/// Validates answers against the manifest's questionnaire and collects them for analysis. Answers
/// that its quality rules leave out, and those of participants who are left out, are validated but
/// not collected.
///
/// Throws Faults with all faults: stimuli and items not in the questionnaire, answers of another
/// kind of trial, values that are out of range or contradict the raw answer, choices that were not
/// offered, and rows of several designs. Throws Error if the manifest has no questionnaire or no
/// answers remain.
AnswerSet collect_answers(const Manifest& manifest, std::vector<AnswerRow> rows,
                          const ReportChoices& choices = {});

/// A count with its noun in singular or plural: "1 person", "2 people".
std::string counted_noun(std::size_t count, const std::string& one, const std::string& several);

/// Whether any participant had attention checks.
bool has_attention_checks(const AnswerSet& answer_set);

/// A sentence on included participants: "5 of 6 participants analysed".
std::string people_sentence(const AnswerSet& answer_set);

/// A sentence for each participant who did not finish, which states whether the answers are
/// included.
std::vector<std::string> unfinished_sentences(const AnswerSet& answer_set);

}  // namespace mien::pipeline
