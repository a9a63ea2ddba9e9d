#include "pipeline/farm/farm_status.h"

#include <algorithm>
#include <array>
#include <iterator>

#include "motion/text/as_number.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/farm/film_lengths.h"
#include "pipeline/farm/film_progress.h"
#include "pipeline/farm/jobs/unresponsive_jobs.h"
#include "pipeline/farm/stages.h"
#include "pipeline/farm/submission.h"
#include "pipeline/production/run/run.h"
#include "pipeline/tasks/disk_fault.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

/// What people call a task's products, in the order in which they are made.
constexpr std::array share_names = {"motions", "films", "clips", "dots", "sheets", "study"};

std::string share_of(const Task& task) {
  if (task.kind == "clip") return "clips";
  return task.kind == "dots" ? "dots" : stage_of(task);
}

std::vector<StageProgress> stage_shares(const TaskGraph& graph,
                                        const std::vector<TaskOutcome>& outcomes) {
  std::vector<StageProgress> shares;
  for (const char* name : share_names) shares.push_back({name, 0, 0});
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    const auto share = std::ranges::find(shares, share_of(graph.tasks[i]), &StageProgress::name);
    ++share->total;
    share->done += outcomes[i].state == TaskState::cached ? 1 : 0;
  }
  std::erase_if(shares, [](const StageProgress& share) { return share.total == 0; });
  return shares;
}

/// Films and the frames that are kept of them, by key.
using KeptFrames = std::map<std::string, std::map<Hash, int>>;

KeptFrames kept_frames(const TaskGraph& graph, const fs::path& folder) {
  KeptFrames kept;
  for (const Task& task : graph.tasks) {
    if (task.kind == "film")
      kept[task.id] = frames_in_the_making(folder, task.id.substr(task.id.find(':') + 1));
  }
  return kept;
}

/// The frames of a film that is not complete. Those of earlier states of the study are of no use.
int frames_kept_of(const Task& film, const TaskGraph& graph,
                   const std::vector<TaskOutcome>& outcomes, const KeptFrames& kept) {
  if (outcomes[graph.index_of(film.id)].state != TaskState::due) return 0;
  const std::map<Hash, int>& by_key = kept.at(film.id);
  const auto found = by_key.find(stored_sequence(film, graph, outcomes).key);
  return found == by_key.end() ? 0 : found->second;
}

StageProgress frames_share(const Production& production, const std::vector<TaskOutcome>& outcomes,
                           const KeptFrames& kept, const fs::path& folder) {
  StageProgress frames{"frames", 0, 0};
  const std::map<std::string, int> lengths = film_lengths(production, folder);
  const TaskGraph& graph = production.graph();
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    const Task& task = graph.tasks[i];
    const auto length = lengths.find(task.id);
    if (task.kind != "film" || length == lengths.end()) continue;
    frames.total += length->second;
    frames.done += outcomes[i].state == TaskState::cached
                       ? length->second
                       : std::min(length->second, frames_kept_of(task, graph, outcomes, kept));
  }
  return frames;
}

StudyState state_of(const Production& production, const std::vector<TaskOutcome>& outcomes,
                    const fs::path& folder, const std::string& words) {
  const TaskGraph& graph = production.graph();
  StudyState state;
  state.folder = folder;
  state.graph_key = graph_key(graph, folder);
  state.words = words;
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    if (outcomes[i].state == TaskState::cached) state.done.insert(graph.tasks[i].id);
  }
  state.has_all_artifacts = state.done.size() == graph.tasks.size();
  state.is_complete = state.has_all_artifacts && is_recorded(production, outcomes, folder);
  return state;
}

NodeStatus& node_called(const std::string& name, std::vector<NodeStatus>& nodes) {
  const auto found = std::ranges::find(nodes, name, &NodeStatus::name);
  if (found != nodes.end()) return *found;
  nodes.push_back({name, 0, 0, {}, 0.0});
  return nodes.back();
}

void add_workers(const std::vector<WorkerReport>& reports, FarmStatus& status) {
  for (const WorkerReport& report : reports) {
    if (!report.is_alive()) continue;
    NodeStatus& node = node_called(report.host, status.nodes);
    ++node.workers;
    for (const auto& [task, share] : report.tasks) node.tasks.push_back(task);
    node.frames_per_second += report.frames_per_second();
  }
}

void add_jobs(const std::vector<JobStatus>& statuses, FarmStatus& status) {
  for (const JobStatus& job_status : statuses) {
    for (const QueueRow& row : job_status.live()) {
      if (is_stuck(row)) continue;  // reported as a problem
      if (row.node.empty() || row.state == "PENDING") {
        ++status.waiting[row.reason];
      } else {
        ++node_called(row.node, status.nodes).elements;
      }
    }
  }
}

/// Nothing is written of it where a log would be, on that disk.
std::string disk_problem_now(const fs::path& folder, const std::string& key,
                             const std::optional<std::vector<QueueRow>>& queue) {
  std::error_code unknown;
  if (fs::exists(folder, unknown)) return current_disk_problem(folder);
  const bool has_jobs = queue && !live_jobs_of_graph(*queue, key).empty();
  return has_jobs ? folder.string() +
                        " does not exist, but Slurm has jobs that work in it: check that its disk "
                        "is mounted on this machine"
                  : "";
}

std::optional<double> seconds_left(const FarmStatus& status) {
  double pace = 0.0;
  for (const NodeStatus& node : status.nodes) pace += node.frames_per_second;
  if (pace <= 0.0 || status.is_complete) return std::nullopt;
  return (status.frames.total - status.frames.done) / pace;
}

bool is_frame(const fs::path& file) {
  return motion::as_number<unsigned>(file.stem().string()).has_value();
}

}  // namespace

int FarmStatus::running() const {
  int count = 0;
  for (const NodeStatus& node : nodes) count += node.elements;
  return count;
}

bool FarmStatus::is_active() const {
  return running() > 0 || !waiting.empty() ||
         std::ranges::any_of(nodes, [](const NodeStatus& node) { return node.workers > 0; });
}

std::map<Hash, int> frames_in_the_making(const fs::path& folder, const std::string& film) {
  std::map<Hash, int> counts;
  for (const fs::path& sequence : paths_in(folder / ".mien" / "partial" / "frames" / film)) {
    const std::vector<fs::path> frames = paths_in(sequence / "frames");
    counts[sequence.filename().string()] =
        static_cast<int>(std::ranges::count_if(frames, is_frame));
  }
  return counts;
}

/// Only the item itself removes its record: a chunk of a film that was then made whole does not.
std::vector<FailedItem> present_failures(const TaskGraph& graph, const StudyState& state) {
  std::vector<FailedItem> failed = failed_items(state.folder);
  std::erase_if(failed, [&](const FailedItem& one) {
    const std::string task = one.item.substr(0, one.item.find('['));
    return !graph.has(task) || state.done.contains(task);
  });
  return failed;
}

StudyState study_state(const Production& production, const fs::path& folder,
                       const std::string& words) {
  return state_of(production, quick_plan(production.graph(), folder), folder, words);
}

FarmStatus farm_status(const Production& production, const fs::path& folder,
                       const std::optional<std::vector<QueueRow>>& queue, const std::string& fault,
                       const std::string& words, const NodeStates& nodes) {
  FarmStatus status;
  status.study = production.manifest().study;
  status.folder = folder.string();
  status.words = words;
  // Before the films: a film that is made now loses its frames only when it is there itself.
  const KeptFrames kept = kept_frames(production.graph(), folder);
  const std::vector<TaskOutcome> outcomes = quick_plan(production.graph(), folder);
  status.stages = stage_shares(production.graph(), outcomes);
  status.frames = frames_share(production, outcomes, kept, folder);
  const StudyState state = state_of(production, outcomes, folder, words);
  status.is_complete = state.is_complete;
  status.lacks_record = state.has_all_artifacts && !state.is_complete;
  status.disk = disk_problem_now(folder, state.graph_key, queue);
  status.failed = present_failures(production.graph(), state);
  const std::vector<WorkerReport> workers = worker_reports(folder);
  add_workers(workers, status);
  if (queue) {
    const JournalContent journal = SubmissionJournal(folder).read();
    const std::vector<JobStatus> statuses = job_statuses(journal, *queue, folder);
    add_jobs(statuses, status);
    status.problems = job_problems(statuses, state);
    std::erase_if(status.problems, [](const JobProblem& problem) {
      return problem.kind == JobProblem::Kind::cancelled;
    });
    std::ranges::move(unresponsive_jobs(statuses, {workers, nodes, status.disk.empty()}, words),
                      std::back_inserter(status.problems));
    if (!status.is_complete) status.losses = lost_job_messages(statuses);
  } else {
    status.without_slurm = fault;
  }
  std::ranges::sort(status.nodes, {}, &NodeStatus::name);
  status.seconds_left = seconds_left(status);
  return status;
}

}  // namespace mien::pipeline
