#include "pipeline/farm/slurm/slurm.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <regex>
#include <sstream>
#include <string_view>

#include <fmt/format.h>

#include "motion/text/as_number.h"

namespace mien::pipeline {

namespace {

constexpr std::string_view configuration_remedy =
    "Slurm's configuration cannot be read: unset SLURM_CONF, or set it to the cluster's slurm.conf";

constexpr std::string_view no_room_remedy =
    "Slurm has reached its job limit for all users (scontrol show config | grep MaxJobCount): use "
    "a larger --chunk for fewer jobs, or try again when other jobs have ended";

struct Remedy {
  std::string_view words;  ///< in what Slurm says
  std::string_view remedy;
};

// Slurm's words and what mends it; the first that is found counts.
constexpr std::array remedies = {
    Remedy{"Unable to contact slurm controller",
           "Slurm's controller does not answer: try again later, or ask the administrators "
           "(scontrol ping)"},
    Remedy{"Connection refused", "Slurm's controller does not answer: scontrol ping"},
    Remedy{"Socket timed out", "Slurm's controller is slow: try again, nothing is submitted twice"},
    Remedy{"ould not establish a configuration source",
           "this machine is not part of a cluster: log in to one that is, or set SLURM_CONF"},
    Remedy{"unable to status file", configuration_remedy},
    Remedy{"nable to process configuration file", configuration_remedy},
    Remedy{"arse error in file", configuration_remedy},
    Remedy{"nable to establish control machine address",
           "this machine cannot resolve the controller named in slurm.conf: check SLURM_CONF"},
    Remedy{"unable to determine hostname", "this machine is not part of a cluster"},
    Remedy{
        "munge",
        "the authentication service munge is not running on this machine: ask the administrators"},
    Remedy{"nable to accept job", no_room_remedy},
    Remedy{"job queue full", no_room_remedy},
    Remedy{"Job creation temporarily disabled",
           "the cluster accepts no jobs at the moment: try again later"},
    Remedy{"Invalid job array specification",
           "the site allows smaller arrays: scontrol show config | grep MaxArraySize"},
    Remedy{"invalid partition", "there is no such partition: sinfo lists them"},
    Remedy{"Invalid account",
           "the account is not yours: sacctmgr show associations user=$USER lists yours"},
    Remedy{"Invalid qos", "there is no such QOS: sacctmgr show qos lists them"},
    Remedy{"emory specification can not be satisfied",
           "no node has that much memory: use a smaller --mem"},
    Remedy{"equested node configuration is not available",
           "no node has that many processors or that much memory: use a smaller --jobs or --mem "
           "(sinfo -N -l)"},
    Remedy{"equested time limit is invalid",
           "the partition allows less time: use a shorter --time (sinfo lists the limits)"},
    Remedy{"nvalid time limit", "--time takes minutes, HH:MM:SS or D-HH:MM:SS"},
    Remedy{"QOSMaxSubmitJobPerUserLimit",
           "the site allows you fewer jobs at a time: use a larger --chunk for fewer jobs"},
    Remedy{"ob violates accounting",
           "the site's limits are reached: use a larger --chunk for fewer jobs"},
    Remedy{"ccess denied", "the partition or account is not open to you: sinfo, sacctmgr"},
};

std::string without_end(std::string text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
  return text;
}

/// Output of Slurm, indented below a message of mien.
std::string quoted(const std::string& words) {
  return "  " + std::regex_replace(words, std::regex("\n"), "\n  ");
}

/// A configuration that is not there is looked for during a minute.
void refuse_missing_configuration() {
  const char* file = std::getenv("SLURM_CONF");
  std::error_code unknown;
  if (file == nullptr || *file == '\0' || std::filesystem::exists(file, unknown)) return;
  throw SlurmFault(std::string("SLURM_CONF names ") + file +
                   ", which does not exist: unset it, or set it to the cluster's slurm.conf");
}

/// Whether sbatch was still retrying at the time limit because no job is accepted at present.
bool is_full(const CommandResult& end) {
  return end.timed_out && end.errors.find("retrying") != std::string::npos;
}

/// Whether a submission may have been accepted although the command failed.
bool is_unanswered(const CommandResult& end) {
  return end.timed_out || end.errors.find("Socket timed out") != std::string::npos ||
         end.errors.find("Zero Bytes were transmitted") != std::string::npos;
}

/// Whether scancel has nothing to complain of but that jobs were over.
bool had_ended(const CommandResult& end) {
  if (end.is_missing || end.timed_out) return false;
  std::istringstream lines(end.errors);
  for (std::string line; std::getline(lines, line);) {
    if (line.find("Invalid job id") == std::string::npos &&
        line.find("already completing or completed") == std::string::npos) {
      return false;
    }
  }
  return true;
}

}  // namespace

std::string slurm_fault(const std::string& program, const CommandResult& end) {
  if (end.is_missing) {
    return program +
           " was not found: Slurm is not installed on this machine; log in to a machine of the "
           "cluster, or use mien run, which does not need Slurm";
  }
  const std::string words = without_end(end.errors.empty() ? end.output : end.errors);
  for (const Remedy& one : remedies) {
    if (end.errors.find(one.words) == std::string::npos) continue;
    return program + " failed: " + std::string(one.remedy) + "\n" + quoted(words);
  }
  if (end.timed_out) {
    return program + " did not answer in time; scontrol ping shows whether Slurm is up" +
           (words.empty() ? "" : "\n" + quoted(words));
  }
  return program + " failed: " + words;
}

CommandResult Slurm::run(const std::vector<std::string>& words) const {
  refuse_missing_configuration();
  CommandResult end = run_command(words, limit_);
  if (!end.succeeded()) throw SlurmFault(slurm_fault(words.front(), end));
  return end;
}

bool Slurm::is_installed() const {
  return !run_command({"squeue", "--version"}, limit_).is_missing;
}

SlurmSite Slurm::site() const { return parse_site(run({"scontrol", "show", "config"}).output); }

std::vector<NodeShape> Slurm::nodes() const {
  return node_shapes(run_command({"sinfo", "-h", "-N", "-o", node_format}, limit_).output);
}

NodeStates Slurm::node_states() const {
  return pipeline::node_states(
      run_command({"sinfo", "-h", "-N", "-o", node_state_format}, limit_).output);
}

std::vector<QueueRow> Slurm::queue() const {
  return queue_rows(run({"squeue", "-h", "-r", "-a", "-t", "all", "-o", queue_format}).output);
}

std::optional<std::vector<QueueRow>> Slurm::queue_if_any(std::string& why) const {
  try {
    return queue();
  } catch (const SlurmFault& fault) {
    why = fault.what();
    return std::nullopt;
  }
}

std::string Slurm::submit(const std::filesystem::path& script,
                          const std::vector<std::string>& after,
                          const std::vector<std::string>& more) const {
  std::vector<std::string> words = {"sbatch", "--parsable"};
  if (!after.empty())
    words.push_back(fmt::format("--dependency=afterany:{}", fmt::join(after, ":")));
  words.insert(words.end(), more.begin(), more.end());
  words.push_back(script.string());
  const CommandResult end = run_command(words, limit_);
  if (is_full(end)) throw SlurmQueueFull(slurm_fault("sbatch", end));
  if (!end.succeeded() && is_unanswered(end)) throw SlurmTimeout(slurm_fault("sbatch", end));
  if (!end.succeeded()) throw SlurmFault(slurm_fault("sbatch", end));
  // "17", or "17;cluster" where there are several.
  const std::string job = end.output.substr(0, end.output.find_first_of(";\n"));
  if (motion::as_number<unsigned>(job)) return job;
  throw SlurmTimeout("sbatch returned no job: " + without_end(end.output));
}

void Slurm::cancel(const std::vector<std::string>& jobs) const {
  constexpr std::size_t at_once = 500;
  for (std::size_t first = 0; first < jobs.size(); first += at_once) {
    std::vector<std::string> words = {"scancel"};
    const std::size_t last = std::min(jobs.size(), first + at_once);
    words.insert(words.end(), jobs.begin() + static_cast<std::ptrdiff_t>(first),
                 jobs.begin() + static_cast<std::ptrdiff_t>(last));
    const CommandResult end = run_command(words, limit_);
    if (!end.succeeded() && !had_ended(end)) throw SlurmFault(slurm_fault("scancel", end));
  }
}

}  // namespace mien::pipeline
