#include "pipeline/farm/ended_elements.h"

#include <charconv>
#include <fstream>
#include <string>
#include <system_error>

#include "pipeline/farm/worker_codes.h"

namespace mien::pipeline {

std::map<std::pair<std::string, int>, ElementEnd> ends_in(const std::filesystem::path& submission) {
  std::map<std::pair<std::string, int>, ElementEnd> ends;
  std::error_code error;
  for (std::filesystem::directory_iterator at(submission / "ends", error), end; !error && at != end;
       at.increment(error)) {
    const std::string name = at->path().filename().string();
    const std::size_t dot = name.rfind('.');
    if (dot == std::string::npos) continue;
    int element = 0;
    std::from_chars(name.data() + dot + 1, name.data() + name.size(), element);
    std::ifstream file(at->path());
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
