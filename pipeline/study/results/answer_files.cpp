#include "pipeline/study/results/answer_files.h"

#include <algorithm>
#include <string>

#include "motion/error.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view saved_answers = "answers_data";

/// Browsers name a second download "… (1).csv".
bool is_table_of_answers(const fs::path& file) {
  const std::string name = file.filename().string();
  return name == "answers.csv" ||
         (file.extension() == ".csv" && name.find(saved_answers) != std::string::npos);
}

std::vector<fs::path> tables_in(const fs::path& folder) {
  std::vector<fs::path> tables;
  if (!fs::is_directory(folder)) return tables;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.is_regular_file() && is_table_of_answers(entry.path()))
      tables.push_back(entry.path());
  std::ranges::sort(tables);
  return tables;
}

std::vector<fs::path> tables_below(const fs::path& folder) {
  for (const char* part : {"", "data", "answers", "answers/data"}) {
    std::vector<fs::path> tables = tables_in(*part == '\0' ? folder : folder / part);
    if (!tables.empty()) return tables;
  }
  throw Error({folder.string()}, "holds no answers",
              "name the folder that contains answers.csv or the saved *answers_data.csv files");
}

/// The table of participants of a table of answers; empty where there is none.
fs::path participants_beside(const fs::path& answers) {
  const std::string name = answers.filename().string();
  const auto at = name.find(saved_answers);
  std::vector<std::string> names;
  if (at != std::string::npos)
    for (const char* other : {"participant_data", "participants_data"})
      names.push_back(name.substr(0, at) + other + name.substr(at + saved_answers.size()));
  names.push_back(participants_of(answers).filename().string());
  names.emplace_back("participants.csv");
  for (const std::string& other : names)
    if (fs::exists(answers.parent_path() / other)) return answers.parent_path() / other;
  return {};
}

void add_once(std::vector<fs::path>& files, const fs::path& file) {
  if (std::ranges::find(files, file) == files.end()) files.push_back(file);
}

}  // namespace

fs::path participants_of(const fs::path& answers) {
  return answers.parent_path() / (answers.stem().string() + "_participants.csv");
}

AnswerFiles answer_files(const std::vector<fs::path>& given) {
  AnswerFiles found;
  for (const fs::path& named : given) {
    const bool is_folder = fs::is_directory(named);
    for (const fs::path& table : is_folder ? tables_below(named) : std::vector{named}) {
      add_once(found.answers, table);
      const fs::path participants = participants_beside(table);
      if (!participants.empty()) add_once(found.participants, participants);
    }
  }
  return found;
}

}  // namespace mien::pipeline
