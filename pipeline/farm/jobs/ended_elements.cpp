#include "pipeline/farm/jobs/ended_elements.h"

#include <fstream>

#include "motion/text/as_number.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/farm/slurm/worker_codes.h"

namespace mien::pipeline {

std::map<std::pair<std::string, int>, ElementEnd> ends_in(const std::filesystem::path& submission) {
  std::map<std::pair<std::string, int>, ElementEnd> ends;
  for (const std::filesystem::path& end : paths_in(submission / "ends")) {
    const std::string name = end.filename().string();
    const std::size_t dot = name.rfind('.');
    if (dot == std::string::npos) continue;
    const int element = motion::as_number<int>(name.substr(dot + 1)).value_or(0);
    std::ifstream file(end);
    ElementEnd told;
    if (element < 1 || !(file >> told.code)) continue;
    std::string node;
    std::string lack;
    file >> told.restarts >> node >> lack;
    told.lacked_memory = lack == lack_of_memory;
    ends.emplace(std::pair(name.substr(0, dot), element), told);
  }
  return ends;
}

}  // namespace mien::pipeline
