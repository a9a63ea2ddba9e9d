#include "pipeline/farm/worker.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include <nlohmann/json.hpp>

#include "motion/error.h"
#include "motion/text/excerpt.h"
#include "motion/text/file_contents.h"
#include "motion/text/nearest_word.h"
#include "motion/text/shell_word.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/farm/jobs/submission_journal.h"
#include "pipeline/farm/slurm/worker_codes.h"
#include "pipeline/farm/work_item.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

const Task& task_meant(const TaskGraph& graph, const WorkItem& item) {
  if (!graph.has(item.task)) {
    std::vector<std::string> ids;
    for (const Task& task : graph.tasks) ids.push_back(task.id);
    throw Error("there is no task " + motion::in_quotes(item.task),
                motion::did_you_mean(item.task, ids));
  }
  const Task& task = graph.task(item.task);
  if (item.chunks > 0 && !task.make_part)
    throw Error(motion::in_quotes(item.task) + " is not made in chunks",
                "only films are; omit [ ]");
  return task;
}

void add_inputs(const TaskGraph& graph, const Task& task, std::set<std::size_t>& needed) {
  for (const auto* earlier : {&task.inputs, &task.after}) {
    for (const std::string& id : *earlier) {
      const std::size_t index = graph.index_of(id);
      if (needed.insert(index).second) add_inputs(graph, graph.tasks[index], needed);
    }
  }
}

/// Adds the requested tasks and their inputs, chunks of a film before the film.
class ItemGraph {
 public:
  explicit ItemGraph(const TaskGraph& graph) : graph_(graph) {}

  void add(const WorkItem& item) {
    const Task& task = task_meant(graph_, item);
    add_inputs(graph_, task, needed_);
    if (item.chunks == 0) {
      needed_.insert(graph_.index_of(task.id));
    } else {
      parts_[graph_.index_of(task.id)].insert({item.chunk, item.chunks});
    }
  }

  TaskGraph build() const {
    std::set<std::size_t> all = needed_;
    for (const auto& [film, parts] : parts_) all.insert(film);
    TaskGraph built;
    for (const std::size_t index : all) {
      Task task = graph_.tasks[index];
      if (const auto parts = parts_.find(index); parts != parts_.end()) {
        for (const auto& [number, of] : parts->second) {
          Task part = part_of(graph_.tasks[index], {number, of});
          task.inputs.push_back(part.id);  // without products it has no part in the film's key
          built.add(std::move(part));
        }
      }
      if (needed_.contains(index)) built.add(std::move(task));
    }
    return built;
  }

 private:
  const TaskGraph& graph_;
  std::set<std::size_t> needed_;
  std::map<std::size_t, std::set<std::pair<int, int>>> parts_;
};

int code_of(const TaskOutcome& outcome) {
  if (outcome.is_bad_input) return worker_bad_input;
  if (outcome.is_disk_fault) return worker_disk_unavailable;
  return outcome.is_transient ? worker_transient : worker_gave_up;
}

/// Why an item was not completed: its own failure, or the first one among the tasks before it.
/// `seen`: tasks that were looked at already, to which the function adds.
const TaskOutcome* cause_of(const TaskGraph& graph, const std::vector<TaskOutcome>& outcomes,
                            std::size_t index, std::set<std::size_t>& seen) {
  if (outcomes[index].state == TaskState::failed) return &outcomes[index];
  if (!seen.insert(index).second) return nullptr;
  const Task& task = graph.tasks[index];
  for (const auto* earlier : {&task.inputs, &task.after}) {
    for (const std::string& id : *earlier) {
      if (const TaskOutcome* cause = cause_of(graph, outcomes, graph.index_of(id), seen))
        return cause;
    }
  }
  return nullptr;
}

bool is_made(const TaskOutcome& outcome) {
  return outcome.state == TaskState::cached || outcome.state == TaskState::made;
}

int attempts_before(const fs::path& file) {
  const motion::FileReading text = motion::bytes_of_file(file, motion::max_document_bytes);
  const ordered_json record =
      text.bytes ? ordered_json::parse(*text.bytes, nullptr, false) : ordered_json::object();
  const bool is_record = record.is_object() && record.contains("attempts");
  return is_record && record["attempts"].is_number_integer() ? record["attempts"].get<int>() : 0;
}

void write_failure_record(const fs::path& folder, const FailedWork& failed,
                          const std::string& command, const WorkerRecord& self) {
  const fs::path file = failure_path(folder, failed.item);
  const ordered_json record = {
      {"item", failed.item},
      {"error", failed.error},
      {"code", failed.code},
      {"host", self.host},
      {"when", utc_now()},
      {"attempts", attempts_before(file) + 1},
      {"command", command + " --tasks " + motion::shell_word(failed.item)}};
  make_folder(file.parent_path());
  fs::path next = file;
  next += "." + self.name + ".new";
  replace_file(file, next,
               record.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n");
}

}  // namespace

TaskGraph graph_of_items(const TaskGraph& graph, const std::vector<std::string>& items) {
  ItemGraph wanted(graph);
  for (const std::string& item : items) wanted.add(work_item(item));
  return wanted.build();
}

/// Transient failures take precedence, because they may not recur.
int WorkResult::code() const {
  if (was_interrupted) return worker_transient;
  constexpr std::array rising = {0, worker_bad_input, worker_gave_up, worker_transient,
                                 worker_disk_unavailable};
  auto most = std::find(rising.begin(), rising.end(), nondeterminism.empty() ? 0 : worker_gave_up);
  for (const FailedWork& item : failed)
    most = std::max(most, std::find(rising.begin(), rising.end(), item.code));
  return most == rising.end() ? worker_gave_up : *most;
}

fs::path failure_path(const fs::path& folder, const std::string& item) {
  std::string name = item;
  for (char& letter : name) {
    if (std::string("/[]:").find(letter) != std::string::npos) letter = '_';
  }
  return folder / "farm" / "failures" / (name + ".json");
}

WorkResult work(const TaskGraph& items, const std::vector<std::string>& names,
                const fs::path& folder, int jobs, const std::stop_token& stop,
                const RunObserver& observer, const std::string& command) {
  Store store(folder);
  const std::vector<TaskOutcome> outcomes = run(items, store, jobs, stop, observer);
  WorkResult result;
  for (const std::string& name : names) {
    const std::size_t index = items.index_of(name);
    std::set<std::size_t> seen;
    if (is_made(outcomes[index])) {
      std::error_code none;
      fs::remove(failure_path(folder, name), none);
    } else if (const TaskOutcome* cause = cause_of(items, outcomes, index, seen)) {
      result.failed.push_back({name, cause->error, code_of(*cause)});
      try {
        write_failure_record(folder, result.failed.back(), command, store.heartbeat().self());
      } catch (const std::exception&) {  // NOLINT(bugprone-empty-catch): the disk is full, perhaps,
      }                                  // and the failure itself is in the job's log
    } else {
      result.was_interrupted = true;  // without a failure, only a stop leaves a task unmade
    }
  }
  result.repairs = store.repairs();
  result.nondeterminism = store.nondeterminism();
  return result;
}

}  // namespace mien::pipeline
