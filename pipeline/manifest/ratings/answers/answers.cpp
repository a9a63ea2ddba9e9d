#include "pipeline/manifest/ratings/answers/answers.h"

#include <map>
#include <utility>

#include <fmt/format.h>

#include "motion/text/excerpt.h"
#include "pipeline/base/documents/fault.h"
#include "pipeline/base/documents/table.h"
#include "pipeline/manifest/ratings/answers/counted_answers.h"
#include "pipeline/manifest/ratings/answers/study_answers.h"
#include "pipeline/manifest/ratings/answers/unknown_names.h"
#include "pipeline/manifest/ratings/answers/word_answers.h"

namespace mien::pipeline {

namespace {

/// The warnings with the file's name only: they go into tables, which do not depend on its folder.
std::vector<std::string> sentences_of(const std::vector<StudyWarning>& warnings) {
  std::vector<std::string> sentences;
  for (const StudyWarning& warning : warnings) {
    Place place = warning.place;
    place.file = std::filesystem::path(place.file).filename().string();
    sentences.push_back(to_string(place) + ": " + warning.text);
  }
  return sentences;
}

/// The warnings in the same form.
std::vector<std::string> sentences_of(std::vector<Fault> warnings) {
  std::vector<std::string> sentences;
  for (Fault& warning : warnings) {
    warning.place.file = std::filesystem::path(warning.place.file).filename().string();
    sentences.push_back(to_string(warning));
  }
  return sentences;
}

/// The rows of a table of words that are about the examples.
CsvTable rows_about(CsvTable table, const AnswerSubjects& about, const AnswerRules& rules,
                    std::vector<StudyWarning>& warnings) {
  if (about.examples.empty()) return table;
  const int named = find_column(table, "stimulus");
  const int column = named >= 0 ? named : require_column(table, "motion");
  std::set<std::string> known;
  std::vector<std::string> names;
  for (const RatedExample& example : about.examples) {
    known.insert(example.name);
    if (!example.file_stem.empty()) known.insert(example.file_stem);
    names.push_back(example.name);
  }
  UnknownNames unknown("stimulus", "stimuli");
  std::erase_if(table.rows, [&](const std::vector<CsvField>& row) {
    const CsvField& stimulus = row[static_cast<std::size_t>(column)];
    if (known.contains(stimulus.text)) return false;
    if (!about.left_out.contains(stimulus.text)) unknown.note(stimulus);
    return true;
  });
  std::vector<Fault> faults;
  unknown.report(table, names, rules, faults, warnings);
  if (!faults.empty()) throw Faults(faults);
  return table;
}

Answers answers_of(const CsvTable& table, const ScaleSet& scales, const AnswerSubjects& about) {
  if (table.rows.empty()) {
    throw Error(Place{table.file, 1, 1}, "holds no answers", "add rows below the header");
  }
  using Unknown = AnswerRules::Unknown;
  const AnswerRules rules{.unknown = about.ignore_unknown ? Unknown::ignore : Unknown::refuse,
                          .plain = true,
                          .left_out = about.left_out};
  std::vector<StudyWarning> warnings;
  Answers answers;
  if (holds_answer_rows(table)) {
    CountedAnswers counted = counted_answers(table, scales);
    answers = answers_of(counted.table, scales, about);
    std::vector<std::string> first = sentences_of(counted.warnings);
    first.insert(first.end(), counted.notes.begin(), counted.notes.end());
    answers.warnings.insert(answers.warnings.begin(), first.begin(), first.end());
    return answers;
  }
  if (holds_words(table)) {
    const CsvTable rows = rows_about(table, about, rules, warnings);
    answers = answers_from_words(rows, scales, Unmentioned::neutral).answers;
  } else {
    StudyAnswers study = study_answers(table, scales, about.examples, rules);
    answers = study.plain();
    warnings = std::move(study.warnings);
  }
  answers.warnings = sentences_of(warnings);
  return answers;
}

constexpr auto plain_columns = table_of<WithOrigin<Answer>>(
    "answers.csv", "answer on a scale",
    {{"participant", "", "who answered", [](auto& r) { return r.of.participant; }},
     {"stimulus", "", "what was rated", [](auto& r) { return r.of.stimulus; }},
     {"scale", "", "id of the scale", [](auto& r) { return r.of.scale; }},
     {"value", "scale", "the answer, in the scale's range", [](auto& r) { return r.of.value; }},
     {"simulated*", "", "1; there where nobody answered",
      [](auto& r) { return std::vector<std::string>(r.simulated ? 1 : 0, "1"); }}});

/// Takes each row once; counts by session what was there again.
class RowsTakenOnce {
 public:
  void add(AnswerRow row) {
    if (met_.insert(fields_of_row(row)).second) {
      result.rows.push_back(std::move(row));
    } else {
      ++again_[{row.participant, row.session}];
    }
  }

  AnswersOfFiles finished() {
    for (const auto& [who, count] : again_)
      result.notes.push_back(
          fmt::format("participant {}, session {}: {} answer{} {} saved more than once and "
                      "counted once",
                      motion::in_quotes(who.first),
                      who.second.empty() ? "without a name" : motion::excerpt(who.second), count,
                      count == 1 ? "" : "s", count == 1 ? "was" : "were"));
    return std::move(result);
  }

  AnswersOfFiles result;

 private:
  std::set<std::vector<std::string>> met_;
  std::map<std::pair<std::string, std::string>, int> again_;
};

}  // namespace

Answers read_answers(const std::filesystem::path& file, const ScaleSet& scales,
                     const AnswerSubjects& about) {
  return answers_of(read_csv(file), scales, about);
}

Answers parse_answers(std::string_view csv, const std::string& file, const ScaleSet& scales,
                      const AnswerSubjects& about) {
  return answers_of(parse_csv(csv, file), scales, about);
}

std::string to_csv(const Answers& answers) {
  const std::vector<std::string> if_simulated(answers.simulated ? 1 : 0);
  return plain_columns.of_parts(answers.simulated, answers.answers, if_simulated).csv;
}

AnswersOfFiles answers_of_files(const std::vector<std::filesystem::path>& files) {
  RowsTakenOnce taken;
  std::vector<Fault> warnings;
  for (const std::filesystem::path& file : files)
    for (AnswerRow& row : answer_rows(read_csv(file), DuplicateAnswers::allowed, &warnings))
      taken.add(std::move(row));
  AnswersOfFiles all = taken.finished();
  all.warnings = std::move(warnings);
  const std::vector<Fault> faults = duplicate_answer_faults(all.rows);
  if (!faults.empty()) throw Faults(faults);
  return all;
}

}  // namespace mien::pipeline
