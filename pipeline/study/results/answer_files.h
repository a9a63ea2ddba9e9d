#pragma once

#include <filesystem>
#include <vector>

namespace mien::pipeline {

/// Tables of answers and tables of participants.
struct AnswerFiles {
  std::vector<std::filesystem::path> answers;
  std::vector<std::filesystem::path> participants;
};

/// Finds the tables in files and folders named by a user.
///
/// In a folder: its answers.csv and the *answers_data.csv that the page saves and exports name, in
/// the folder itself, or else in data/, answers/ or answers/data/ below it, whichever has any
/// first; by name. The table of participants beside each table of answers is found by name: for
/// `x_description-answers_data.csv` the `x_description-participant_data.csv` (or
/// participants_data), for others participants.csv. Each table is listed once.
///
/// Throws Error for a folder without any answers.
AnswerFiles answer_files(const std::vector<std::filesystem::path>& given);

}  // namespace mien::pipeline
