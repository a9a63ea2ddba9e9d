#include "pipeline/tasks/progress.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ostream>
#include <utility>

#include <fmt/format.h>

#include "pipeline/base/documents/printable_stream.h"

namespace mien::pipeline {

namespace {

bool is_to_be_made(const TaskOutcome& planned) { return planned.state != TaskState::cached; }

constexpr double seconds_between_lines = 10.0;
constexpr double seconds_between_bars = 0.1;
constexpr int bar_width = 30;
constexpr char clear_line[] = "\r\x1b[K";

}  // namespace

Progress::Progress(std::ostream& out, bool terminal, const TaskGraph& graph,
                   const std::vector<TaskOutcome>& plan, ProgressBar::Clock clock)
    : out_(out), terminal_(terminal), bar_(out, terminal, std::move(clock)) {
  for (std::size_t i = 0; i < graph.tasks.size(); ++i) {
    if (is_to_be_made(plan[i])) total_cost_ += graph.tasks[i].cost_seconds;
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

std::string as_duration(double seconds) {
  const auto total = static_cast<long>(std::max(0.0, std::round(seconds)));
  if (total < 3600) return fmt::format("{}:{:02}", total / 60, total % 60);
  return fmt::format("{}:{:02}:{:02}", total / 3600, total / 60 % 60, total % 60);
}

double steady_seconds() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now).count();
}

ProgressBar::ProgressBar(std::ostream& out, bool terminal, Clock clock)
    : out_(out),
      terminal_(terminal),
      clock_(std::move(clock)),
      start_(clock_()),
      last_shown_(start_) {}

ProgressBar::~ProgressBar() { clear(); }

void ProgressBar::show(double share, const std::string& name, bool at_once) {
  const double now = clock_();
  const double pause = terminal_ ? seconds_between_bars : seconds_between_lines;
  if (!at_once && now - last_shown_ < pause) return;
  last_shown_ = now;
  const int percent = static_cast<int>(std::floor(100.0 * share));
  const double elapsed = now - start_;
  const std::string left = share > 0.01 && elapsed > 1.0
                               ? ", " + as_duration(seconds_left(share, elapsed)) + " left"
                               : "";
  if (!terminal_) {
    out_ << percent << " %" << left << '\n' << std::flush;
    return;
  }
  const auto filled = static_cast<std::size_t>(std::lround(bar_width * share));
  put_control(out_, clear_line);
  out_ << '[' << std::string(filled, '#') << std::string(bar_width - filled, '.') << "] " << percent
       << " %" << left << "  " << name << std::flush;
}

double ProgressBar::seconds_left(double share, double elapsed) const {
  constexpr double most_weight = 0.1;  // of what was expected, as a share of the work
  const double weight = expected_s_ > 0.0 ? most_weight * std::pow(1.0 - share, 3.0) : 0.0;
  return (1.0 - share) * (elapsed + weight * expected_s_) / (share + weight);
}

void ProgressBar::clear() {
  if (!terminal_) return;
  put_control(out_, clear_line);
  out_.flush();
}

}  // namespace mien::pipeline
