#include "pipeline/tasks/progress.h"

#include <algorithm>
#include <ostream>
#include <utility>

namespace mien::pipeline {

namespace {

bool takes_time(const TaskOutcome& planned) { return planned.state != TaskState::cached; }

}  // namespace

Progress::Progress(std::ostream& out, bool terminal, const TaskGraph& graph,
                   const std::vector<TaskOutcome>& plan, ProgressBar::Clock clock)
    : out_(out), terminal_(terminal), bar_(out, terminal, std::move(clock)) {
  for (std::size_t i = 0; i < graph.tasks.size(); ++i) {
    if (takes_time(plan[i])) total_cost_ += graph.tasks[i].cost_seconds;
  }
  bar_.expect(total_cost_);
}

RunObserver Progress::observer() {
  return {[this](const Task& task) { started(task); },
          [this](const Task& task, double share) { progressed(task, share); },
          [this](const Task& task, const TaskOutcome& outcome) { ended(task, outcome); }};
}

void Progress::started(const Task& task) {
  running_[task.id] = 0.0;
  show(false);
}

void Progress::progressed(const Task& task, double share) {
  running_[task.id] = share * task.cost_seconds;
  show(false);
}

void Progress::ended(const Task& task, const TaskOutcome& outcome) {
  running_.erase(task.id);
  const bool failed = outcome.state == TaskState::failed;
  if (outcome.state == TaskState::made || failed) {
    done_cost_ += task.cost_seconds;
    bar_.clear();
    if (failed || !terminal_) out_ << task.id << (failed ? " failed" : " made") << '\n';
  }
  show(failed);
}

/// Tasks that had to be made again against the plan can bring more cost than was planned.
double Progress::share_done() const {
  double done = done_cost_;
  for (const auto& [id, cost] : running_) done += cost;
  return std::clamp(done / std::max(total_cost_, 1e-9), 0.0, 1.0);
}

void Progress::show(bool at_once) {
  bar_.show(share_done(), running_.empty() ? "" : running_.begin()->first, at_once);
}

}  // namespace mien::pipeline
