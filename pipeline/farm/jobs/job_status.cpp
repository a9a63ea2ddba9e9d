#include "pipeline/farm/jobs/job_status.h"

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

JobStatus status_of_job(const JournalJob& job, std::vector<QueueRow> rows, const fs::path& folder) {
  JobStatus job_status;
  job_status.journal = job;
  job_status.rows = std::move(rows);
  if (job.job.empty() && !job_status.rows.empty()) {
    job_status.is_adopted = true;
    job_status.journal.job = job_status.rows.front().array;
  }
  if (std::any_of(job_status.rows.begin(), job_status.rows.end(), is_live)) {
    job_status.kind = JobStatus::Kind::live;
  } else if (!job_status.rows.empty() || job.was_refused || job.was_cancelled) {
    job_status.kind = JobStatus::Kind::ended;
  } else if (job.job.empty()) {
    job_status.kind = JobStatus::Kind::unconfirmed;
  } else {
    job_status.kind = has_begun(job, folder) ? JobStatus::Kind::ended : JobStatus::Kind::lost;
  }
  return job_status;
}

bool is_needed(const JobStatus& job_status, const std::set<std::string>& due,
               const fs::path& folder) {
  if (job_status.kind == JobStatus::Kind::live) return true;
  if (job_status.journal.elements == 0) return false;
  return std::ranges::any_of(lines_of_list(list_of(job_status.journal, folder)),
                             [&](const auto& line) {
                               return std::ranges::any_of(line, [&](const std::string& item) {
                                 return due.contains(item.substr(0, item.find('[')));
                               });
                             });
}

}  // namespace

std::vector<QueueRow> JobStatus::live() const {
  std::vector<QueueRow> found;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(found), is_live);
  return found;
}

std::vector<JobStatus> job_statuses(const JournalContent& journal,
                                    const std::vector<QueueRow>& queue, const fs::path& folder) {
  std::map<std::string, std::vector<QueueRow>> by_comment;
  for (const QueueRow& row : queue) by_comment[row.comment].push_back(row);
  std::vector<JobStatus> statuses;
  for (const JournalJob& job : journal.jobs) {
    const auto rows = by_comment.find(job.comment);
    statuses.push_back(status_of_job(
        job, rows == by_comment.end() ? std::vector<QueueRow>() : rows->second, folder));
  }
  return statuses;
}

std::string name_of(const QueueRow& row) {
  return row.index ? row.array + "_" + std::to_string(*row.index) : row.job;
}

std::vector<std::string> live_jobs(const std::vector<JobStatus>& statuses) {
  std::vector<std::string> jobs;
  for (const JobStatus& job_status : statuses) {
    for (const QueueRow& row : job_status.live()) jobs.push_back(name_of(row));
  }
  return jobs;
}

std::vector<std::string> live_jobs_of_graph(const std::vector<QueueRow>& queue,
                                            const std::string& graph_key) {
  std::vector<std::string> jobs;
  for (const QueueRow& row : queue) {
    if (is_live(row) && row.comment.starts_with("mien:" + graph_key + ":"))
      jobs.push_back(name_of(row));
  }
  return jobs;
}

std::vector<std::string> lost_job_messages(const std::vector<JobStatus>& statuses) {
  std::vector<std::string> result;
  for (const JobStatus& job_status : statuses) {
    if (job_status.journal.submission != statuses.back().journal.submission) continue;
    const std::string name = job_status.journal.submission + "/" + job_status.journal.name;
    if (job_status.kind == JobStatus::Kind::lost) {
      result.push_back("Slurm no longer has job " + job_status.journal.job + " (" + name +
                       "), which left no log: it was lost by the controller, cancelled by hand, or "
                       "ended before writing one");
    } else if (job_status.kind == JobStatus::Kind::unconfirmed) {
      result.push_back(name + " was to be submitted, but no such job exists");
    }
  }
  return result;
}

std::map<std::pair<std::string, int>, ElementExit> read_element_exits(
    const std::filesystem::path& submission) {
  std::map<std::pair<std::string, int>, ElementExit> ends;
  for (const std::filesystem::path& end : paths_in(submission / "ends")) {
    const std::string name = end.filename().string();
    const std::size_t dot = name.rfind('.');
    if (dot == std::string::npos) continue;
    const int element = motion::as_number<int>(name.substr(dot + 1)).value_or(0);
    std::ifstream file(end);
    ElementExit result;
    if (element < 1 || !(file >> result.code)) continue;
    std::string node;
    std::string lack;
    file >> result.restarts >> node >> lack;
    result.out_of_memory = lack == out_of_memory_note;
    ends.emplace(std::pair(name.substr(0, dot), element), result);
  }
  return ends;
}

std::vector<std::string> removable_submissions(const std::vector<JobStatus>& statuses,
                                               const std::set<std::string>& due,
                                               const fs::path& folder) {
  std::map<std::pair<std::size_t, std::string>, bool> needed;  // "9999" before "10000"
  for (const JobStatus& job_status : statuses) {
    const std::string& number = job_status.journal.submission;
    if (!motion::as_number<unsigned>(number)) continue;  // else it is no submission's folder
    bool& is = needed[{number.size(), number}];
    is = is || is_needed(job_status, due, folder);
  }
  std::vector<std::string> removable;
  std::size_t newer = needed.size();
  for (const auto& [number, is] : needed) {
    if (--newer >= retained_submissions && !is) removable.push_back(number.second);
  }
  return removable;
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
