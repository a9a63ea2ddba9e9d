#pragma once

#include <functional>
#include <iosfwd>
#include <map>
#include <string>

#include "pipeline/tasks/task_graph.h"

namespace mien::pipeline {

/// Time of a monotonic clock, seconds.
double steady_seconds();

/// A duration in seconds as text: "0:07", "12:30", "1:02:03".
std::string as_duration(double seconds);

/// Shows progress and the estimated remaining time: a bar on a terminal, otherwise a plain line
/// every ten seconds.
class ProgressBar {
 public:
  using Clock = std::function<double()>;  ///< monotonic time, seconds

  /// Writes to `out`, which must outlive the object.
  ProgressBar(std::ostream& out, bool terminal, Clock clock = steady_seconds);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// Sets the estimated total duration. The remaining time is based on it at first, and
  /// increasingly on the time elapsed.
  void expect(double seconds) { expected_s_ = seconds; }

  /// Shows that `share` (0 … 1) is done and `name` is in progress. Does nothing shortly after the
  /// last output unless `at_once`.
  void show(double share, const std::string& name, bool at_once = false);

  /// Clears the bar from a terminal, before other output.
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

/// Shows the progress of a run: on a terminal, a bar with the remaining time and a line for each
/// failed task; otherwise plain lines, one for each completed or failed task and one every ten
/// seconds in between. Cached tasks have no lines.
class Progress {
 public:
  /// Writes to `out`, which must outlive the object. Tasks that are cached in `plan` are assumed to
  /// take no time.
  Progress(std::ostream& out, bool terminal, const TaskGraph& graph,
           const std::vector<TaskOutcome>& plan, ProgressBar::Clock clock);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Callbacks for a run, which refer to this object.
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
