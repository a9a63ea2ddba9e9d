#include "pipeline/farm/jobs/unresponsive_jobs.h"

#include <algorithm>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "motion/text/excerpt.h"

namespace mien::pipeline {

namespace {

/// Workers report every few seconds from their start. Slurm measures how long a job has run, and
/// the file system how old a report is: clocks of machines are not compared, but five minutes are
/// allowed for reports that a shared file system shows late.
constexpr double report_timeout_s = 420.0;

std::string node_state_of(const std::string& node, const NodeStates& nodes) {
  const auto found = nodes.find(node);
  return found == nodes.end() ? "" : found->second;
}

/// Whether a node does not answer, which Slurm marks by a star.
bool is_away(const std::string& node_state) {
  return node_state.ends_with('*') || node_state.starts_with("down");
}

/// Slurm drains a node that cannot end a job's processes.
bool is_out_of_use(const std::string& node_state) {
  return node_state.starts_with("drain") || node_state.starts_with("fail");
}

/// A worker without a job number counts for any job of its node: it was started by hand or by an
/// older version.
bool has_worker(const QueueRow& row, const std::vector<WorkerReport>& workers) {
  return std::ranges::any_of(workers, [&](const WorkerReport& worker) {
    return !worker.has_ended && worker.report_age_s < report_timeout_s &&
           (worker.job == row.job || (worker.job.empty() && worker.host == row.node));
  });
}

/// Why a job counts as unresponsive; empty if it does not.
std::string unresponsiveness_cause(const QueueRow& row, const LivenessEvidence& evidence) {
  const std::string node = node_state_of(row.node, evidence.nodes);
  const bool is_ending = row.state == "COMPLETING";
  if (row.node.empty() || (row.state != "RUNNING" && !is_ending)) return "";
  if (is_away(node)) return fmt::format("{} does not answer ({})", row.node, node);
  if (is_ending) {
    return is_out_of_use(node) ? fmt::format("{} cannot end their processes ({})", row.node, node)
                               : "";
  }
  if (!evidence.folder_is_usable || seconds_run(row) < report_timeout_s ||
      has_worker(row, evidence.workers))
    return "";
  return fmt::format(
      "their workers on {} have not reported for minutes: they have died, or are waiting for the "
      "study's folder, which that node cannot reach or write to",
      row.node);
}

/// "scancel 17_3 17_4", of so many at most.
std::string scancel_of(const std::vector<JobProblem>& jobs) {
  std::vector<std::string> names;
  for (const JobProblem& one : jobs) names.push_back(one.job);
  return "scancel " + motion::first_of(names, 20, " ");
}

std::string remedy_for(const std::vector<JobProblem>& jobs, const std::string& node,
                       const std::string& study) {
  return fmt::format(
      "scontrol show node {0} shows its state; {1}, then mien farm resume {2} submits what is "
      "missing. Jobs that remain nevertheless end when an administrator takes the node down: "
      "scontrol update NodeName={0} State=DOWN Reason=silent",
      node, scancel_of(jobs), study);
}

}  // namespace

std::vector<JobProblem> unresponsive_jobs(const std::vector<JobStatus>& statuses,
                                          const LivenessEvidence& evidence,
                                          const std::string& study) {
  std::map<std::pair<std::string, std::string>, std::vector<JobProblem>> by_cause;
  for (const JobStatus& job_status : statuses) {
    for (const QueueRow& row : job_status.live()) {
      const std::string cause = unresponsiveness_cause(row, evidence);
      if (cause.empty()) continue;
      by_cause[{cause, row.node}].push_back(
          {JobProblem::Kind::unresponsive, job_status.journal.submission,
           fmt::format("{}.{}", job_status.journal.name, row.index.value_or(1)), name_of(row),
           row.reason, cause, ""});
    }
  }
  std::vector<JobProblem> unresponsive;
  for (auto& [cause_and_node, jobs] : by_cause) {
    const std::string remedy = remedy_for(jobs, cause_and_node.second, study);
    for (JobProblem& job : jobs) {
      job.remedy = remedy;
      unresponsive.push_back(std::move(job));
    }
  }
  return unresponsive;
}

}  // namespace mien::pipeline
