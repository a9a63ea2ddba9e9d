#include "pipeline/farm/jobs/element_logs.h"

#include <algorithm>
#include <fstream>
#include <functional>
#include <map>

#include "motion/text/as_number.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/farm/jobs/task_list.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

/// Files and folders of a folder by name, the last first.
std::vector<fs::path> entries_of(const fs::path& folder) {
  std::vector<fs::path> entries = paths_in(folder);
  std::ranges::sort(entries, std::greater{});
  return entries;
}

/// Folders of submissions, the newest first.
std::vector<fs::path> submissions_in(const fs::path& folder) {
  std::vector<fs::path> submissions = entries_of(folder / "farm");
  std::erase_if(submissions, [](const fs::path& path) {
    return !motion::as_number<unsigned>(path.filename().string());
  });
  return submissions;
}

/// Logs are called <study>-<name>-<job>_<element>.log; the newest of each element by
/// "<name>.<element>".
std::map<std::string, fs::path> logs_by_element(const fs::path& submission) {
  std::map<std::string, fs::path> logs;
  std::vector<std::string> names;
  for (const fs::path& file : entries_of(submission)) {
    if (file.extension() == ".sbatch") names.push_back(file.stem().string());
  }
  std::error_code error;
  for (const fs::path& log : entries_of(submission / "log")) {
    const std::string stem = log.stem().string();
    const std::size_t dash = stem.rfind('-');
    if (dash == std::string::npos) continue;
    const std::size_t line = std::min(stem.find('_', dash), stem.size());
    const std::string element = line < stem.size() ? stem.substr(line + 1) : "1";
    // The longest name: "2-frames-2" ends with no other's.
    std::string owner;
    for (const std::string& name : names) {
      if (stem.substr(0, dash).ends_with("-" + name) && name.size() > owner.size()) owner = name;
    }
    if (owner.empty()) continue;
    fs::path& newest = logs[owner + "." + element];
    if (newest.empty() || fs::last_write_time(newest, error) < fs::last_write_time(log, error)) {
      newest = log;
    }
  }
  return logs;
}

std::vector<ElementLog> logs_in(const fs::path& submission, const std::string& item) {
  std::vector<ElementLog> found;
  const std::map<std::string, fs::path> logs = logs_by_element(submission);
  for (const auto& [element, log] : logs) {
    const std::size_t dot = element.rfind('.');
    const auto lines = lines_of_list(submission / (element.substr(0, dot) + ".tasks"));
    const auto line = motion::as_number<std::size_t>(element.substr(dot + 1)).value_or(0);
    if (line < 1 || line > lines.size()) continue;
    const bool has_item = std::ranges::any_of(lines[line - 1], [&](const std::string& one) {
      return one == item || one.starts_with(item + "[");
    });
    if (has_item) found.push_back({item, log});
  }
  return found;
}

}  // namespace

std::vector<ElementLog> find_logs(const std::string& item, const fs::path& folder) {
  for (const fs::path& submission : submissions_in(folder)) {
    if (auto logs = logs_in(submission, item); !logs.empty()) return logs;
  }
  return {};
}

std::vector<ElementLog> find_logs(const std::vector<JobProblem>& problems, const fs::path& folder) {
  std::map<std::string, std::map<std::string, fs::path>> logs;  // by submission and element
  std::vector<ElementLog> found;
  for (const JobProblem& one : problems) {
    const auto [submission, is_new] = logs.try_emplace(one.submission);
    if (is_new) submission->second = logs_by_element(folder / "farm" / one.submission);
    const auto log = submission->second.find(one.element);
    if (log == submission->second.end()) continue;
    found.push_back({one.submission + "/" + one.element + ", " + one.cause, log->second});
  }
  return found;
}

std::string last_lines(const fs::path& file, int lines) {
  constexpr std::streamoff most = 65536;
  std::ifstream stream(file, std::ios::binary | std::ios::ate);
  if (!stream) return "";
  stream.seekg(std::max<std::streamoff>(0, stream.tellg() - std::streampos(most)));
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  while (text.ends_with('\n')) text.pop_back();
  std::size_t begin = text.size();
  for (int i = 0; i < lines && begin != std::string::npos; ++i) {
    begin = begin == 0 ? std::string::npos : text.rfind('\n', begin - 1);
  }
  if (begin != std::string::npos) text.erase(0, begin + 1);
  return text.empty() ? "" : text + "\n";
}

}  // namespace mien::pipeline
