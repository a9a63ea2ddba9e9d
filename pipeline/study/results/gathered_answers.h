#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/manifest/manifest.h"
#include "pipeline/manifest/ratings/answers/answer_row.h"
#include "pipeline/manifest/ratings/answers/counted_answers.h"
#include "pipeline/manifest/ratings/scales/scales.h"

namespace mien::pipeline {

/// A stimulus as results are told about it.
struct ReportedStimulus {
  std::string id;
  std::string made;     ///< level of the factor made: acted, modified, as-is …; may be empty
  std::string emotion;  ///< level of the factor emotion; may be empty
  /// Levels of all other factors that the manifest states: "woman, walk". Stimuli are compared
  /// within a setting.
  std::string setting;
  Factors factors;

  /// Whether it is what others are modified from: neutral or normal in its emotion, or as it is.
  bool is_neutral() const;
};

/// One rating that counts. Indices are those of Gathered.
struct CountedRating {
  std::size_t person = 0;
  std::size_t stimulus = 0;
  std::size_t scale = 0;
  double value = 0.0;  ///< in the scale's own range
};

/// Which of a list somebody saw in a stimulus.
struct CountedChoice {
  std::size_t person = 0;
  std::size_t stimulus = 0;
  std::string chosen;
};

/// Which of two stimuli somebody chose.
struct CountedPreference {
  std::size_t person = 0;
  std::size_t chosen = 0;
  std::size_t other = 0;
  std::string item;
};

/// What somebody wrote: a comment, or an answer in words (then with the scale as its item).
struct Remark {
  std::string participant;
  std::string stimulus;
  std::string item;
  std::string text;
};

/// How the answers are looked at, where that is not as the manifest says.
struct ReportChoices {
  std::optional<TestCorrection> correction;
  std::optional<int> max_failed_checks;
  std::map<std::uint64_t, int> planned;  ///< trials of a session, by the seed of its order
  std::set<std::string> finished;        ///< participants whose tables say that they were done
  bool without_unfinished = false;       ///< who did not finish is left out
};

/// Who gave fewer answers than were planned.
struct Unfinished {
  std::string participant;
  int trials = 0;   ///< that were done
  int planned = 0;  ///< that there were to do
};

/// The answers of a questionnaire, sorted for all that is reckoned with them.
struct Gathered {
  std::string study;
  std::string title;
  std::vector<std::string> people;  ///< those who count
  std::vector<ReportedStimulus> stimuli;
  std::vector<Scale> scales;
  std::vector<std::pair<std::string, std::string>> choices;  ///< of emotion trials
  int points = 5;  ///< of a scale, from one end to the other; 11 places of a slider
  std::vector<CountedRating> ratings;
  std::vector<CountedChoice> chosen;
  std::vector<CountedPreference> preferences;
  std::vector<Remark> remarks;
  std::vector<Remark> words;
  std::vector<Attention> attention;  ///< of everybody
  AttentionRule rule;
  std::vector<Unfinished> unfinished;
  bool without_unfinished = false;
  std::set<std::string> worded_questions;  ///< about participants, whose answers are no numbers
  TestCorrection correction = TestCorrection::holm;
  double alpha = 0.05;
  bool simulated = false;
  std::string design;              ///< hash of the questionnaire that was run; may be empty
  std::vector<std::string> notes;  ///< sentences on what was left out or told apart
};

/// Checks answers against the manifest's questionnaire and sorts them.
///
/// Throws Faults with every fault at once: stimuli and items that the questionnaire does not ask
/// about, answers of another kind than it asks for, values outside the scale's range or that
/// contradict the raw answer, choices that were not offered, and rows of several designs. Throws
/// Error where the manifest has no questionnaire, or nothing is left that counts.
Gathered gather(const Manifest& manifest, std::vector<AnswerRow> rows,
                const ReportChoices& choices = {});

/// A number and its noun: "1 person", "2 people".
std::string counted(std::size_t count, const std::string& one, const std::string& several);

/// "5 of 6 people count"
std::string people_sentence(const Gathered& gathered);

/// One about each who did not finish, and what became of the answers.
std::vector<std::string> unfinished_sentences(const Gathered& gathered);

}  // namespace mien::pipeline
