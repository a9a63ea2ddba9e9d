#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "motion/text/excerpt.h"
#include "motion/text/shell_word.h"
#include "pipeline/farm/farm_status.h"
#include "pipeline/farm/slurm/job_attempts.h"
#include "pipeline/farm/slurm/worker_codes.h"
#include "pipeline/tasks/progress.h"

namespace mien::pipeline {

namespace {

using nlohmann::ordered_json;

std::string share_text(const StageProgress& share) {
  return fmt::format("  {:<8} {:>7} of {}\n", share.name, share.done, share.total);
}

std::string node_text(const NodeStatus& node) {
  std::string text = "  " + node.name + ":";
  if (node.elements > 0) {
    text += fmt::format(" {} job{}", node.elements, node.elements == 1 ? "" : "s");
  }
  if (node.workers > 0) {
    text += fmt::format("{} {} worker{}", node.elements > 0 ? "," : "", node.workers,
                        node.workers == 1 ? "" : "s");
  }
  if (node.frames_per_second > 0.0)
    text += fmt::format(", {:.2f} frames/s", node.frames_per_second);
  if (!node.tasks.empty()) text += ": " + motion::first_of(node.tasks, 3);
  return text + "\n";
}

std::string waiting_text(const FarmStatus& status) {
  int count = 0;
  std::string reasons;
  for (const auto& [reason, elements] : status.waiting) {
    count += elements;
    reasons += fmt::format("{}{} {}", reasons.empty() ? "" : ", ", elements, reason);
  }
  return count == 0 ? "" : fmt::format("waiting: {} ({})\n", count, reasons);
}

std::string failed_text(const FailedItem& failed) {
  std::string text = fmt::format("  {}: {}", failed.item, failed.error);
  while (text.ends_with('\n')) text.pop_back();
  text += fmt::format("\n    on {}, {}, tried {} time{}\n", failed.host, failed.when,
                      failed.attempts, failed.attempts == 1 ? "" : "s");
  if (!failed.command.empty()) text += "    again: " + failed.command + "\n";
  return text;
}

std::string disk_text(const FarmStatus& status) {
  if (status.disk.empty()) return "";
  if (!status.is_active()) return status.disk + "\n";
  return fmt::format(
      "{}\n  running jobs wait for it, {} per attempt, and continue on their own when it is "
      "available; after {} attempts they are held\n",
      status.disk, as_duration(folder_wait_limit_seconds), most_restarts + 1);
}

/// The last job of a submission writes the record.
std::string record_text(const FarmStatus& status) {
  if (!status.lacks_record) return "";
  return "provenance.json is missing, or describes an earlier state of the study" +
         (status.is_active() ? "\n"
                             : "; mien run " + status.words +
                                   " writes it, and so does mien farm resume with Slurm\n");
}

ordered_json node_json(const NodeStatus& node) {
  return {{"node", node.name},
          {"jobs", node.elements},
          {"workers", node.workers},
          {"tasks", node.tasks},
          {"frames_per_s", node.frames_per_second}};
}

ordered_json problems_json(const FarmStatus& status, JobProblem::Kind kind) {
  ordered_json result = ordered_json::array();
  for (const JobProblem& one : status.problems) {
    if (one.kind != kind) continue;
    result.push_back({{"job", one.job},
                      {"element", one.submission + "/" + one.element},
                      {"reason", one.reason},
                      {"cause", one.cause},
                      {"remedy", one.remedy}});
  }
  return result;
}

}  // namespace

std::string status_text(const FarmStatus& status) {
  std::string text = status.folder + ":";
  if (status.is_complete) {
    text += " everything is done, judging by receipts and sizes; mien verify " +
            motion::shell_path(status.folder) + " reads every byte\n";
  } else {
    text += status.is_active() ? "\n" : " no worker is active\n";
  }
  for (const StageProgress& share : status.stages) {
    text += share_text(share);
    if (share.name == "motions") text += share_text(status.frames);
  }
  text += record_text(status);
  if (!status.nodes.empty()) text += "working:\n";
  for (const NodeStatus& node : status.nodes) text += node_text(node);
  text += waiting_text(status);
  text += disk_text(status);
  text += problems_text(status.problems);
  if (!status.failed.empty())
    text += "failed (mien farm logs " + status.words + " shows details):\n";
  for (const FailedItem& failed : status.failed) text += failed_text(failed);
  for (const std::string& loss : status.losses) text += loss + "\n";
  if (status.seconds_left) {
    text += *status.seconds_left < 1.0
                ? "less than a second left at this pace\n"
                : "about " + as_duration(*status.seconds_left) + " left at this pace\n";
  }
  if (status.without_slurm.empty()) return text;
  // What Slurm itself wrote stands below.
  text += "jobs unknown: " + status.without_slurm.substr(0, status.without_slurm.find('\n')) + "\n";
  if (!status.is_complete && !status.is_active())
    text += "mien run " + status.words + " makes what is missing, and so does mien farm worker\n";
  return text;
}

ordered_json status_json(const FarmStatus& status) {
  const auto share_json = [](const StageProgress& share) {
    return ordered_json{{"done", share.done}, {"total", share.total}};
  };
  ordered_json stages = ordered_json::object();
  for (const StageProgress& share : status.stages) stages[share.name] = share_json(share);
  ordered_json nodes = ordered_json::array();
  for (const NodeStatus& node : status.nodes) nodes.push_back(node_json(node));
  ordered_json failed = ordered_json::array();
  for (const FailedItem& one : status.failed) {
    failed.push_back({{"item", one.item},
                      {"error", one.error},
                      {"code", one.code},
                      {"host", one.host},
                      {"when", one.when},
                      {"attempts", one.attempts},
                      {"command", one.command}});
  }
  ordered_json result = {
      {"study", status.study},
      {"folder", status.folder},
      {"complete", status.is_complete},
      {"active", status.is_active()},
      {"stages", stages},
      {"frames", share_json(status.frames)},
      {"running", status.running()},
      {"nodes", nodes},
      {"waiting", status.waiting},
      {"held", problems_json(status, JobProblem::Kind::held)},
      {"outdated", problems_json(status, JobProblem::Kind::outdated)},
      {"silent", problems_json(status, JobProblem::Kind::unresponsive)},
      {"ended", problems_json(status, JobProblem::Kind::ended)},
      {"failed", failed},
      {"lost", status.losses},
      {"disk", nullptr},
      {"left_s", nullptr},
      {"slurm", status.without_slurm.empty() ? "present" : status.without_slurm}};
  if (status.seconds_left) result["left_s"] = *status.seconds_left;
  if (!status.disk.empty()) result["disk"] = status.disk;
  return result;
}

}  // namespace mien::pipeline
