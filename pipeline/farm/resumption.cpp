#include "pipeline/farm/resumption.h"

#include <algorithm>

#include "pipeline/farm/jobs/task_list.h"
#include "pipeline/farm/memory_amount.h"
#include "pipeline/farm/stages.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

/// Elements, from 1, whose last attempt was short of memory; 1 for a job that is no array.
std::set<std::size_t> diagnose_out_of_memory(const JobStatus& job_status, const fs::path& folder) {
  std::set<std::size_t> elements;
  for (const QueueRow& row : job_status.rows) {
    const bool is_of_array = job_status.journal.elements > 0;
    if (row.state == "OUT_OF_MEMORY" && (row.index || !is_of_array))
      elements.insert(static_cast<std::size_t>(std::max(0, row.index.value_or(1))));
  }
  for (const auto& [element, end] :
       read_element_exits(folder / "farm" / job_status.journal.submission)) {
    if (element.first == job_status.journal.name && end.out_of_memory)
      elements.insert(static_cast<std::size_t>(element.second));
  }
  return elements;
}

}  // namespace

std::set<std::string> covered_items(const std::vector<JobStatus>& statuses,
                                    const fs::path& folder) {
  std::set<std::string> covered;
  for (const JobStatus& job_status : statuses) {
    if (job_status.kind != JobStatus::Kind::live || job_status.journal.elements == 0) continue;
    const auto lines = lines_of_list(list_of(job_status.journal, folder));
    for (const QueueRow& row : job_status.live()) {
      const auto line = static_cast<std::size_t>(row.index.value_or(0));
      if (!will_proceed(row) || line < 1 || line > lines.size()) continue;
      covered.insert(lines[line - 1].begin(), lines[line - 1].end());
    }
  }
  return covered;
}

std::vector<std::string> obsolete_jobs(const std::vector<JobStatus>& statuses) {
  std::vector<std::string> jobs;
  for (const JobStatus& job_status : statuses) {
    for (const QueueRow& row : job_status.live()) {
      const bool is_waiting_rest = job_status.journal.elements == 0 && row.state == "PENDING";
      if (is_waiting_rest || is_stuck(row)) jobs.push_back(name_of(row));
    }
  }
  return jobs;
}

MemoryNeeds memory_needs(const std::vector<JobStatus>& statuses, const fs::path& folder) {
  MemoryNeeds needs;
  for (const JobStatus& job_status : statuses) {
    const std::set<std::size_t> elements = diagnose_out_of_memory(job_status, folder);
    if (elements.empty()) continue;
    const std::string twice = doubled_memory(job_status.journal.memory);
    if (job_status.journal.elements == 0) {
      needs.rest = larger_memory(needs.rest, twice);
      if (twice.empty()) needs.unknown.push_back(job_status.journal.name);
      continue;
    }
    const auto lines = lines_of_list(list_of(job_status.journal, folder));
    for (const std::size_t element : elements) {
      if (element < 1 || element > lines.size()) continue;
      for (const std::string& item : lines[element - 1]) {
        if (twice.empty()) {
          needs.unknown.push_back(item);
        } else {
          std::string& more = needs.more[work_item(item).task];
          more = larger_memory(more, twice);
        }
      }
    }
  }
  return needs;
}

}  // namespace mien::pipeline
