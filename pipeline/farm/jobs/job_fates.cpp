#include "pipeline/farm/jobs/job_fates.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "motion/text/as_number.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/farm/jobs/task_list.h"
#include "pipeline/farm/slurm/worker_codes.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

/// Whether any element of the job has written a log, which each does when it starts.
bool has_begun(const JournalJob& job, const fs::path& folder) {
  const fs::path logs = folder / "farm" / job.submission / "log";
  const std::string stem = "-" + job.name + "-" + job.job;
  return std::ranges::any_of(paths_in(logs), [&](const fs::path& log) {
    const std::string name = log.filename().string();
    return name.find(stem + "_") != std::string::npos || name.ends_with(stem + ".log");
  });
}

JobFate fate_of(const JournalJob& job, std::vector<QueueRow> rows, const fs::path& folder) {
  JobFate fate;
  fate.journal = job;
  fate.rows = std::move(rows);
  if (job.job.empty() && !fate.rows.empty()) {
    fate.is_adopted = true;
    fate.journal.job = fate.rows.front().array;
  }
  if (std::any_of(fate.rows.begin(), fate.rows.end(), is_live)) {
    fate.kind = JobFate::Kind::live;
  } else if (!fate.rows.empty() || job.was_refused || job.was_cancelled) {
    fate.kind = JobFate::Kind::ended;
  } else if (job.job.empty()) {
    fate.kind = JobFate::Kind::unanswered;
  } else {
    fate.kind = has_begun(job, folder) ? JobFate::Kind::ended : JobFate::Kind::lost;
  }
  return fate;
}

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

std::vector<QueueRow> JobFate::live() const {
  std::vector<QueueRow> found;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(found), is_live);
  return found;
}

std::vector<JobFate> job_fates(const JournalContent& journal, const std::vector<QueueRow>& queue,
                               const fs::path& folder) {
  std::map<std::string, std::vector<QueueRow>> by_comment;
  for (const QueueRow& row : queue) by_comment[row.comment].push_back(row);
  std::vector<JobFate> fates;
  for (const JournalJob& job : journal.jobs) {
    const auto rows = by_comment.find(job.comment);
    fates.push_back(
        fate_of(job, rows == by_comment.end() ? std::vector<QueueRow>() : rows->second, folder));
  }
  return fates;
}

std::string name_of(const QueueRow& row) {
  return row.index ? row.array + "_" + std::to_string(*row.index) : row.job;
}

std::vector<std::string> live_jobs(const std::vector<JobFate>& fates) {
  std::vector<std::string> jobs;
  for (const JobFate& fate : fates) {
    for (const QueueRow& row : fate.live()) jobs.push_back(name_of(row));
  }
  return jobs;
}

std::vector<std::string> live_jobs_called(const std::vector<QueueRow>& queue,
                                          const std::string& graph_key) {
  std::vector<std::string> jobs;
  for (const QueueRow& row : queue) {
    if (is_live(row) && row.comment.starts_with("mien:" + graph_key + ":"))
      jobs.push_back(name_of(row));
  }
  return jobs;
}

std::vector<std::string> told_losses(const std::vector<JobFate>& fates) {
  std::vector<std::string> told;
  for (const JobFate& fate : fates) {
    if (fate.journal.submission != fates.back().journal.submission) continue;
    const std::string name = fate.journal.submission + "/" + fate.journal.name;
    if (fate.kind == JobFate::Kind::lost) {
      told.push_back("Slurm no longer has job " + fate.journal.job + " (" + name +
                     "), which left no log: it was lost by the controller, cancelled by hand, or "
                     "ended before writing one");
    } else if (fate.kind == JobFate::Kind::unanswered) {
      told.push_back(name + " was to be submitted, but no such job exists");
    }
  }
  return told;
}

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
    std::error_code ignored;  // remaining files are harmless
    removed += fs::remove_all(folder / "farm" / number, ignored) > 0 && !ignored ? 1 : 0;
  }
  return removed;
}

}  // namespace mien::pipeline
