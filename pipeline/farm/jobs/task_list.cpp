#include "pipeline/farm/jobs/task_list.h"

#include <fstream>
#include <sstream>

namespace mien::pipeline {

std::vector<std::vector<std::string>> lines_of_list(const std::filesystem::path& list) {
  std::vector<std::vector<std::string>> lines;
  std::ifstream file(list);
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::vector<std::string>& items = lines.emplace_back();
    for (std::string item; words >> item;) items.push_back(item);
  }
  return lines;
}

std::filesystem::path list_of(const JournalJob& job, const std::filesystem::path& folder) {
  return folder / "farm" / job.submission / (job.name + ".tasks");
}

}  // namespace mien::pipeline
