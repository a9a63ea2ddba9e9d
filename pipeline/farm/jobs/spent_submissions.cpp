#include "pipeline/farm/jobs/spent_submissions.h"

#include <algorithm>
#include <map>
#include <system_error>
#include <utility>

#include "motion/text/as_number.h"
#include "pipeline/farm/jobs/task_list.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

bool is_needed(const JobFate& fate, const std::set<std::string>& due, const fs::path& folder) {
  if (fate.kind == JobFate::Kind::live) return true;
  if (fate.journal.elements == 0) return false;
  return std::ranges::any_of(lines_of_list(list_of(fate.journal, folder)), [&](const auto& line) {
    return std::ranges::any_of(line, [&](const std::string& item) {
      return due.contains(item.substr(0, item.find('[')));
    });
  });
}

}  // namespace

std::vector<std::string> spent_submissions(const std::vector<JobFate>& fates,
                                           const std::set<std::string>& due,
                                           const fs::path& folder) {
  std::map<std::pair<std::size_t, std::string>, bool> needed;  // "9999" before "10000"
  for (const JobFate& fate : fates) {
    const std::string& number = fate.journal.submission;
    if (!motion::as_number<unsigned>(number)) continue;  // else it is no submission's folder
    bool& is = needed[{number.size(), number}];
    is = is || is_needed(fate, due, folder);
  }
  std::vector<std::string> spent;
  std::size_t newer = needed.size();
  for (const auto& [number, is] : needed) {
    if (--newer >= kept_submissions && !is) spent.push_back(number.second);
  }
  return spent;
}

int remove_submissions(const std::vector<std::string>& numbers, const fs::path& folder) {
  int removed = 0;
  for (const std::string& number : numbers) {
    std::error_code ignored;  // what cannot be removed harms nobody
    removed += fs::remove_all(folder / "farm" / number, ignored) > 0 && !ignored ? 1 : 0;
  }
  return removed;
}

}  // namespace mien::pipeline
