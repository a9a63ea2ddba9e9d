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
/// In a folder, the tables of answers are answers.csv and *answers_data*.csv (as saved by the page
/// and by exports), sorted by name. They are searched for in the folder itself and then in data/,
/// answers/ and answers/data/ below it, until one of these contains any. The table of participants
/// is expected in the same folder as the answers: `x_description-participant_data.csv` (or
/// participants_data) for `x_description-answers_data.csv`, otherwise participants_of the answers,
/// otherwise participants.csv. Each table is listed once.
///
/// Throws Error for a folder without answers.
AnswerFiles answer_files(const std::vector<std::filesystem::path>& given);

/// The table of participants of a table of simulated answers: "pilot_participants.csv" beside
/// "pilot.csv".
std::filesystem::path participants_of(const std::filesystem::path& answers);

}  // namespace mien::pipeline
