#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/manifest/ratings/answers/answer_row.h"

namespace mien::pipeline {

/// Answers out of several files.
struct AnswersOfFiles {
  std::vector<AnswerRow> rows;
  std::vector<std::string> told;  ///< sentences: what was there more than once
};

/// Reads what a questionnaire wrote, in the order of the files. Rows that are the same to the last
/// field, as when a participant saved the files of a session again, are taken once and told of.
///
/// Throws Faults as answer_rows; two answers of one session that differ are a fault.
AnswersOfFiles answers_of_files(const std::vector<std::filesystem::path>& files);

}  // namespace mien::pipeline
