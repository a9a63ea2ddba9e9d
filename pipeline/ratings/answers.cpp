#include "pipeline/ratings/answers.h"

#include "pipeline/documents/csv.h"
#include "pipeline/ratings/study_answers.h"
#include "pipeline/ratings/word_answers.h"

namespace mien::pipeline {

namespace {

Answers answers_of(const CsvTable& table, const ScaleSet& scales) {
  if (table.rows.empty()) {
    throw Error(Place{table.file}, "holds no answers", "add rows below the header");
  }
  if (holds_words(table)) return answers_from_words(table, scales, Unmentioned::neutral).answers;
  return study_answers(table, scales, {}, {.plain = true}).plain();
}

}  // namespace

Answers read_answers(const std::filesystem::path& file, const ScaleSet& scales) {
  return answers_of(read_csv(file), scales);
}

Answers parse_answers(std::string_view csv, const std::string& file, const ScaleSet& scales) {
  return answers_of(parse_csv(csv, file), scales);
}

std::string to_csv(const Answers& answers) {
  std::vector<std::string> header = {"participant", "stimulus", "scale", "value"};
  if (answers.simulated) header.emplace_back("simulated");
  CsvWriter writer(header);
  for (const Answer& answer : answers.answers) {
    std::vector<std::string> row = {answer.participant, answer.stimulus, answer.scale,
                                    shortest(answer.value)};
    if (answers.simulated) row.emplace_back("1");
    writer.row(row);
  }
  return writer.text();
}

}  // namespace mien::pipeline
