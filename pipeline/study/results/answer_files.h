#pragma once

#include <filesystem>
#include <vector>

namespace mien::pipeline {

/// Tables of answers, and those of who gave them.
struct AnswerFiles {
  std::vector<std::filesystem::path> answers;
  std::vector<std::filesystem::path> participants;
};

/// What a file or folder named by a user holds.
///
/// Of a folder: its answers.csv and the *answers_data.csv that the page saves and exports name, in
/// the folder itself, or else in data/, answers/ or answers/data/ below it, whichever has any
/// first; by name. Beside each table of answers its table of participants is taken: of
/// `x_description-answers_data.csv` the `x_description-participant_data.csv` (or
/// participants_data), of others participants.csv. A table is named once.
///
/// Throws Error for a folder without any answers.
AnswerFiles answer_files(const std::vector<std::filesystem::path>& given);

}  // namespace mien::pipeline
