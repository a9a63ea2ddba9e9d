#pragma once

#include <functional>
#include <iosfwd>
#include <map>
#include <string>

#include "pipeline/tasks/task_graph.h"

namespace mien::pipeline {

/// Seconds of a clock that is never set back.
double steady_seconds();

/// "0:07", "12:30", "1:02:03".
std::string as_duration(double seconds);

/// How far something is and how long it will still take: one bar on a terminal, else a plain line
/// every ten seconds.
class ProgressBar {
 public:
  using Clock = std::function<double()>;  ///< seconds, ascending

  /// Writes to `out`, which outlives it.
  ProgressBar(std::ostream& out, bool terminal, Clock clock = steady_seconds);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// All is thought to take so many seconds: what is left is told by that at first, and more and
  /// more by how long it has taken so far.
  void expect(double seconds) { expected_s_ = seconds; }

  /// A share from 0 to 1 is done and `name` is being worked on. Says nothing when it has just said
  /// something, unless it has to `at_once`.
  void show(double share, const std::string& name, bool at_once = false);

  /// Makes room for other text on a terminal.
  void clear();

 private:
  double seconds_left(double share, double elapsed) const;

  std::ostream& out_;
  bool terminal_;
  Clock clock_;
  double start_;
  double last_shown_;
  double expected_s_ = 0.0;
};

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
