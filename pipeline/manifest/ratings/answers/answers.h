#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/manifest/ratings/answers/answer_row.h"
#include "pipeline/manifest/ratings/scales/scales.h"

namespace mien::pipeline {

/// One answer of one participant, or the mean of several people's (`participant` empty).
struct Answer {
  std::string participant;
  std::string stimulus;  ///< what was rated: an example's name or its file's stem
  std::string scale;     ///< id
  double value = 0.0;    ///< in the scale's own range
};

/// The answers of a rating study.
struct Answers {
  std::vector<Answer> answers;
  bool simulated = false;  ///< made up, not given by people; every output that uses them says so
  std::vector<std::string> warnings = {};  ///< what was left out: plain sentences
};

/// An example as ratings may name it.
struct RatedExample {
  std::string name;
  std::string file_stem;  ///< empty for a built-in one
};

/// What answers may be about.
struct AnswerSubjects {
  std::vector<RatedExample> examples;
  std::set<std::string> left_out;  ///< known, and passed over: files that are no examples
  bool ignore_unknown = false;     ///< other stimuli and scales are left out, and reported
};

/// Reads a tidy CSV: columns stimulus, scale, value and, unless the values are means, participant;
/// others (rt_s, order, comment …) are ignored. A column `simulated` with anything but 0 (or
/// nothing) marks answers that nobody gave. A table of words (word_answers.h) is turned into
/// answers, what is not mentioned counting as neutral. The answers of a questionnaire
/// (answer_row.h) are read as they are: counted_answers says which count.
///
/// An empty value or "NA" is a missing answer.
///
/// Throws Error, of all rows at once (Faults), with lines and columns: a column missing, a value
/// that is no number or outside the scale's range, the same participant answering twice, and,
/// unless `about.unknown` says that they are left out, a scale that `scales` does not know and a
/// stimulus that is none of the examples; without examples, answers are about whatever they name.
Answers read_answers(const std::filesystem::path& file, const ScaleSet& scales,
                     const AnswerSubjects& about = {});
Answers parse_answers(std::string_view csv, const std::string& file, const ScaleSet& scales,
                      const AnswerSubjects& about = {});

/// The answers as CSV, with the column `simulated` when they are simulated.
std::string to_csv(const Answers& answers);

/// Answers out of several files.
struct AnswersOfFiles {
  std::vector<AnswerRow> rows;
  std::vector<std::string> notes;  ///< sentences: what was there more than once
};

/// Reads what a questionnaire wrote, in the order of the files. Rows that are the same to the last
/// field, as when a participant saved the files of a session again, are taken once and reported.
///
/// Throws Faults as answer_rows; two answers of one session that differ are a fault.
AnswersOfFiles answers_of_files(const std::vector<std::filesystem::path>& files);

}  // namespace mien::pipeline
