#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/base/documents/fault.h"

namespace mien::pipeline {

/// Files of a command on a study's answers, by kind.
struct AnswerInputs {
  std::vector<std::filesystem::path> answers;
  std::vector<std::filesystem::path> participants;
  std::filesystem::path manifest;
};

/// Sorts the files and folders of a command line: tables (CSV) and folders hold answers
/// (answer_files), anything else is the manifest. With `participants`, these tables replace those
/// that are found. Throws Error if there are no answers, no manifest or two.
AnswerInputs answer_inputs(const std::vector<std::string>& files,
                           const std::vector<std::string>& participants = {});

/// The same, but there may be no answers.
AnswerInputs inputs_with_or_without_answers(const std::vector<std::string>& files,
                                            const std::vector<std::string>& participants = {});

/// The error of a command that needs answers.
Error no_answers();

}  // namespace mien::pipeline
