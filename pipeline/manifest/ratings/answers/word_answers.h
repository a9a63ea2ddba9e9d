#pragma once

#include <string>
#include <vector>

#include "pipeline/base/documents/csv.h"
#include "pipeline/manifest/ratings/answers/answers.h"
#include "pipeline/manifest/ratings/scales/scales.h"

namespace mien::pipeline {

/// What it means that a participant said nothing that lies on a scale.
enum class Unmentioned {
  neutral,   ///< the answer is the middle of the scale
  no_answer  ///< the participant did not answer on this scale
};

/// How much of what participants wrote in a language was understood.
struct WordCoverage {
  std::string language;
  int answers = 0;     ///< with at least one modifier
  int understood = 0;  ///< of these: at least one modifier was
  int modifiers = 0;
  int modifiers_understood = 0;
};

/// A text, in whichever language, and how often it occurs.
struct WordCount {
  std::string language;
  std::string text;  ///< folded
  std::string as;    ///< of a misspelt word: the entry as which it was read
  int count = 0;
};

/// How many answers there are about a stimulus.
struct StimulusCount {
  std::string stimulus;
  int answers = 0;     ///< that could be read at all: in a language of the lexicon
  int understood = 0;  ///< that place the stimulus on a scale
};

/// Answers in words, turned into answers on scales.
struct WordAnswers {
  Answers answers;
  std::vector<WordCoverage> coverage;     ///< in the lexicon's order
  std::vector<WordCount> not_understood;  ///< modifiers, most frequent first
  std::vector<WordCount> respelled;       ///< most frequent first
  std::vector<WordCount> left_out;        ///< languages that the lexicon lacks, and their answers
  std::vector<StimulusCount> stimuli;     ///< by name
};

/// Whether the table holds words (a column `modifier1` and none named `scale`).
bool holds_words(const CsvTable& table);

/// Turns words into answers on −2 … 2 (0 neutral), stretched to each scale's range.
///
/// Columns: participant, language, motion (or stimulus), verb, modifier1, modifier2 …; one row an
/// answer. Each field is read by read_phrase(); a modifier of nothing but words of degree grades
/// what the verb says. Of several mentions of a scale in one answer the strongest counts; equally
/// strong ones of both ends cancel. Answers in languages that the lexicon lacks are left out and
/// counted. With Unmentioned::neutral every answer is about every scale that some answer mentions.
///
/// Throws Error with line and column: a column missing, no words in the scales file, the same
/// participant answering twice about a motion; or when no answer could be read.
WordAnswers answers_from_words(const CsvTable& table, const ScaleSet& scales,
                               Unmentioned unmentioned);

}  // namespace mien::pipeline
