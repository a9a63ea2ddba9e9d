#include "pipeline/farm/jobs/silent_jobs.h"

#include <algorithm>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "motion/text/excerpt.h"

namespace mien::pipeline {

namespace {

/// Workers report every few seconds from their start. The clocks of a cluster's machines, and most
/// likely of its file server, differ by five minutes at most, as Slurm requires.
constexpr double heard_of_within_s = 420.0;

std::string node_state_of(const std::string& node, const NodeStates& nodes) {
  const auto found = nodes.find(node);
  return found == nodes.end() ? "" : found->second;
}

/// A star stands for a node that does not answer.
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
    return !worker.has_ended && worker.silent_s < heard_of_within_s &&
           (worker.job == row.job || (worker.job.empty() && worker.host == row.node));
  });
}

/// Why a job counts as unresponsive; empty if it does not.
std::string silence_of(const QueueRow& row, const SignsOfLife& signs) {
  const std::string node = node_state_of(row.node, signs.nodes);
  const bool is_ending = row.state == "COMPLETING";
  if (row.node.empty() || (row.state != "RUNNING" && !is_ending)) return "";
  if (is_away(node)) return fmt::format("{} does not answer ({})", row.node, node);
  if (is_ending) {
    return is_out_of_use(node) ? fmt::format("{} cannot end their processes ({})", row.node, node)
                               : "";
  }
  if (!signs.folder_is_well || seconds_run(row) < heard_of_within_s ||
      has_worker(row, signs.workers))
    return "";
  return fmt::format(
      "their workers on {} have not reported for minutes: they have died, or are waiting for the "
      "study's folder, which that node cannot reach or write to",
      row.node);
}

/// "scancel 17_3 17_4", of so many at most.
std::string scancel_of(const std::vector<JobTrouble>& jobs) {
  std::vector<std::string> names;
  for (const JobTrouble& one : jobs) names.push_back(one.job);
  return "scancel " + motion::first_of(names, 20, " ");
}

std::string remedy_for(const std::vector<JobTrouble>& jobs, const std::string& node,
                       const std::string& study) {
  return fmt::format(
      "scontrol show node {0} shows its state; {1}, then mien farm resume {2} submits what is "
      "missing. Jobs that remain nevertheless end when an administrator takes the node down: "
      "scontrol update NodeName={0} State=DOWN Reason=silent",
      node, scancel_of(jobs), study);
}

}  // namespace

std::vector<JobTrouble> silent_jobs(const std::vector<JobFate>& fates, const SignsOfLife& signs,
                                    const std::string& study) {
  std::map<std::pair<std::string, std::string>, std::vector<JobTrouble>> by_cause;
  for (const JobFate& fate : fates) {
    for (const QueueRow& row : fate.live()) {
      const std::string cause = silence_of(row, signs);
      if (cause.empty()) continue;
      by_cause[{cause, row.node}].push_back(
          {JobTrouble::Kind::silent, fate.journal.submission,
           fmt::format("{}.{}", fate.journal.name, row.index.value_or(1)), name_of(row), row.reason,
           cause, ""});
    }
  }
  std::vector<JobTrouble> silent;
  for (auto& [cause_and_node, jobs] : by_cause) {
    const std::string remedy = remedy_for(jobs, cause_and_node.second, study);
    for (JobTrouble& job : jobs) {
      job.remedy = remedy;
      silent.push_back(std::move(job));
    }
  }
  return silent;
}

}  // namespace mien::pipeline
