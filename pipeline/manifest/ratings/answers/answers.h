#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/manifest/ratings/answers/answer_row.h"
#include "pipeline/manifest/ratings/scales/scales.h"

namespace mien::pipeline {

/// One answer of a participant, or the mean over several (`participant` empty).
struct Answer {
  std::string participant;
  std::string stimulus;  ///< the rated motion: an example's name or its file's stem
  std::string scale;     ///< id
  double value = 0.0;    ///< value in the scale's range
};

/// The answers of a rating study.
struct Answers {
  std::vector<Answer> answers;
  bool simulated = false;  ///< not given by people; every output that uses the answers states it
  std::vector<std::string> warnings = {};  ///< what was ignored or renamed, as sentences
};

/// The names under which ratings may refer to an example.
struct RatedExample {
  std::string name;
  std::string file_stem;  ///< empty for a built-in example
};

/// The motions that answers may be about.
struct AnswerSubjects {
  std::vector<RatedExample> examples;
  /// Names of files that are not examples; answers about these are ignored.
  std::set<std::string> left_out;
  bool ignore_unknown = false;  ///< ignore and report unknown stimuli and scales
};

/// Reads a tidy CSV with the columns stimulus, scale, value and, unless the values are means,
/// participant; other columns (rt_ms, order, comment …) are ignored. A column `simulated` with any
/// value other than 0 or empty marks simulated answers. A table of words (word_answers.h) is
/// converted to answers, with scales that are not mentioned counted as neutral. The answers of a
/// questionnaire (answer_row.h) are accepted as written; counted_answers selects those that count.
///
/// An empty value or "NA" is a missing answer.
///
/// Throws Error for a missing column or no rows, and Faults for all rows at once, with lines and
/// columns: a value that is not a number or outside the scale's range, a duplicate answer and,
/// unless `about.ignore_unknown` is set, a scale that is not in `scales` or a stimulus that is not
/// an example. If `about` has no examples, any stimulus is accepted. Tables of words and of
/// questionnaires also have the faults for which answers_from_words and counted_answers throw.
Answers read_answers(const std::filesystem::path& file, const ScaleSet& scales,
                     const AnswerSubjects& about = {});
Answers parse_answers(std::string_view csv, const std::string& file, const ScaleSet& scales,
                      const AnswerSubjects& about = {});

/// Returns the answers as CSV, with the column `simulated` if they are simulated.
std::string to_csv(const Answers& answers);

/// Answers from several files.
struct AnswersOfFiles {
  std::vector<AnswerRow> rows;
  std::vector<std::string> notes;  ///< sentences about duplicates
  std::vector<Fault> warnings;     ///< about former names of columns
};

/// Reads the answers of a questionnaire, in the order of the files. Identical rows, which occur
/// when a participant saves the files of a session twice, are read once and reported.
///
/// Throws Faults as answer_rows does, also for conflicting answers within one session.
AnswersOfFiles answers_of_files(const std::vector<std::filesystem::path>& files);

}  // namespace mien::pipeline
