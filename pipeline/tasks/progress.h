#pragma once

#include <iosfwd>
#include <map>
#include <string>

#include "pipeline/tasks/progress_bar.h"
#include "pipeline/tasks/task_graph.h"

namespace mien::pipeline {

/// Shows how a run goes on: one bar with the time left on a terminal, else plain lines, one for
/// each task that was made or failed and one every ten seconds in between.
class Progress {
 public:
  /// Writes to `out`, which outlives it. `plan` tells what is cached: it takes no time.
  Progress(std::ostream& out, bool terminal, const TaskGraph& graph,
           const std::vector<TaskOutcome>& plan, ProgressBar::Clock clock);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Keeps a reference to this object.
  RunObserver observer();

 private:
  void started(const Task& task);
  void progressed(const Task& task, double share);
  void ended(const Task& task, const TaskOutcome& outcome);
  void show(bool at_once);
  double share_done() const;

  std::ostream& out_;
  bool terminal_;
  ProgressBar bar_;
  double total_cost_ = 0.0;
  double done_cost_ = 0.0;
  std::map<std::string, double> running_;  ///< task id → cost done so far
};

}  // namespace mien::pipeline
