#pragma once

#include <string>
#include <vector>

#include "pipeline/base/documents/csv.h"
#include "pipeline/manifest/ratings/answers/answers.h"
#include "pipeline/manifest/ratings/scales/scales.h"

namespace mien::pipeline {

/// The interpretation of a scale that a participant did not mention.
enum class Unmentioned {
  neutral,   ///< the answer is the middle of the scale
  no_answer  ///< the participant did not answer on this scale
};

/// How many of the participants' answers in one language could be interpreted.
struct WordCoverage {
  std::string language;
  int answers = 0;     ///< answers with at least one modifier
  int understood = 0;  ///< answers with at least one interpreted modifier
  int modifiers = 0;
  int modifiers_understood = 0;
};

/// A text in a language and its frequency.
struct WordCount {
  std::string language;
  std::string text;  ///< folded
  std::string as;    ///< for a misspelt word: the entry that it was read as
  int count = 0;
};

/// The number of answers about a stimulus.
struct StimulusCount {
  std::string stimulus;
  int answers = 0;     ///< answers in a language of the lexicon
  int understood = 0;  ///< answers that rate the stimulus on a scale
};

/// Answers in words, converted to answers on scales.
struct WordAnswers {
  Answers answers;
  std::vector<WordCoverage> coverage;     ///< in the lexicon's order
  std::vector<WordCount> not_understood;  ///< modifiers, most frequent first
  std::vector<WordCount> respelled;       ///< most frequent first
  /// Languages missing from the lexicon, named by `text`, with their numbers of answers.
  std::vector<WordCount> left_out;
  std::vector<StimulusCount> stimuli;  ///< sorted by name
};

/// Whether the table contains words (it has a column `modifier1` and no column `scale`).
bool holds_words(const CsvTable& table);

/// Converts words to answers on −2 … 2 (0 neutral), rescaled to each scale's range.
///
/// Columns: participant, language, motion (or stimulus), verb, modifier1, modifier2 …; one row per
/// answer. Each field is read by read_phrase(); a modifier that consists only of degree modifiers
/// modifies the verb's meaning. If an answer mentions a scale several times, the strongest mention
/// counts; equally strong mentions of opposite ends cancel. Answers in languages that are missing
/// from the lexicon are ignored and counted. With Unmentioned::neutral, each answer covers every
/// scale that any answer mentions.
///
/// Throws Error for a missing column, scales without a lexicon, a second answer of a participant
/// about the same motion, or if no answer could be interpreted.
WordAnswers answers_from_words(const CsvTable& table, const ScaleSet& scales,
                               Unmentioned unmentioned);

}  // namespace mien::pipeline
