#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <filesystem>
#include <memory>
#include <mutex>
#include <new>
#include <optional>
#include <set>
#include <string>
#include <system_error>
#include <thread>
#include <utility>

#include "motion/error.h"
#include "pipeline/base/documents/fault.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/tasks/disk_fault.h"
#include "pipeline/tasks/task_graph.h"

namespace mien::pipeline {

namespace {

TaskOutcome with_products(TaskState state, std::vector<Receipt> products) {
  TaskOutcome outcome;
  outcome.state = state;
  outcome.products = std::move(products);
  return outcome;
}

TaskOutcome without_products(TaskState state) { return with_products(state, {}); }

/// A message without the paths of attempts' folders, which no longer exist when it is read.
std::string without_attempts(std::string text, const std::filesystem::path& folder) {
  const std::string attempts = (folder / ".mien" / "attempts").string() + "/";
  for (std::size_t at = text.find(attempts); at != std::string::npos; at = text.find(attempts)) {
    const std::size_t worker = text.find('/', at + attempts.size());
    const std::size_t end = worker == std::string::npos ? worker : text.find('/', worker + 1);
    text.erase(at, end == std::string::npos ? attempts.size() : end + 1 - at);
  }
  return text;
}

/// Number of attempts after transient failures, and the pause before the second; the third waits
/// twice as long.
constexpr int attempts_per_task = 3;
constexpr std::chrono::milliseconds pause_after_failure{300};

/// Interval at which tasks claimed by other processes are checked.
constexpr std::chrono::milliseconds claim_check_interval{200};

TaskOutcome failure(const std::exception& error, const std::filesystem::path& folder) {
  TaskOutcome outcome = without_products(TaskState::failed);
  outcome.error = without_attempts(failure_text(error), folder);
  outcome.is_bad_input = dynamic_cast<const Error*>(&error) != nullptr;
  if (outcome.is_bad_input) return outcome;
  const std::string fault = disk_fault(folder, error);
  if (!fault.empty()) outcome.error = fault;
  outcome.is_disk_fault = !fault.empty();
  outcome.is_transient = outcome.is_disk_fault ||
                         dynamic_cast<const std::system_error*>(&error) != nullptr ||
                         dynamic_cast<const WriteFailure*>(&error) != nullptr ||
                         dynamic_cast<const std::bad_alloc*>(&error) != nullptr;
  return outcome;
}

/// Worker threads that take tasks in graph order as soon as their inputs are available.
class Runner {
 public:
  Runner(const TaskGraph& graph, Store& store, std::stop_token stop, const RunObserver& observer)
      : graph_(graph),
        store_(store),
        stop_(std::move(stop)),
        observer_(observer),
        outcomes_(graph.tasks.size()),
        dependents_(graph.tasks.size()),
        awaited_(graph.tasks.size(), 0),
        tries_(graph.tasks.size(), 0) {
    for (std::size_t i = 0; i < graph.tasks.size(); ++i) {
      const Task& task = graph.tasks[i];
      for (const auto* earlier : {&task.inputs, &task.after}) {
        for (const std::string& id : *earlier) {
          dependents_[graph.index_of(id)].push_back(i);
          ++awaited_[i];
        }
      }
      if (awaited_[i] == 0) ready_.insert(i);
    }
  }

  std::vector<TaskOutcome> run(int jobs) {
    {
      std::vector<std::jthread> workers;
      for (int i = 0; i < jobs; ++i) workers.emplace_back([this] { work(); });
    }
    return std::move(outcomes_);
  }

 private:
  void work() {
    std::unique_lock lock(mutex_);
    while (ended_ < graph_.tasks.size()) {
      if (const auto next = take_next()) {
        perform(*next, lock);
      } else if (!claimed_elsewhere_.empty()) {
        changed_.wait_for(lock, claim_check_interval);
        ready_.merge(claimed_elsewhere_);
      } else if (ended_ < graph_.tasks.size()) {
        changed_.wait(lock);
      }
    }
  }

  static bool has_products(const TaskOutcome& outcome) {
    return outcome.state == TaskState::cached || outcome.state == TaskState::made;
  }

  bool all_made(const std::vector<std::string>& tasks) const {
    return std::ranges::all_of(
        tasks, [&](const std::string& id) { return has_products(outcomes_[graph_.index_of(id)]); });
  }

  std::vector<const TaskOutcome*> inputs_of(const Task& task) const {
    std::vector<const TaskOutcome*> inputs;
    for (const std::string& id : task.inputs) inputs.push_back(&outcomes_[graph_.index_of(id)]);
    return inputs;
  }

  /// Ends tasks that can no longer be started and takes the first one that can.
  std::optional<std::size_t> take_next() {
    while (!ready_.empty()) {
      const std::size_t next = *ready_.begin();
      ready_.erase(ready_.begin());
      const bool is_blocked =
          !all_made(graph_.tasks[next].inputs) || !all_made(graph_.tasks[next].after);
      if (!is_blocked && !stop_.stop_requested()) return next;
      end(next, without_products(is_blocked ? TaskState::skipped : TaskState::interrupted));
    }
    return std::nullopt;
  }

  void end(std::size_t index, TaskOutcome outcome) {
    outcomes_[index] = std::move(outcome);
    ++ended_;
    for (const std::size_t dependent : dependents_[index]) {
      if (--awaited_[dependent] == 0) ready_.insert(dependent);
    }
    if (observer_.ended) observer_.ended(graph_.tasks[index], outcomes_[index]);
    changed_.notify_all();
  }

  void perform(std::size_t index, std::unique_lock<std::mutex>& lock) {
    const Task& task = graph_.tasks[index];
    const auto inputs = inputs_of(task);
    const Hash task_key = task_key_of(task, inputs);
    const std::vector<Hash> keys = product_keys(task, task_key);
    lock.unlock();
    std::optional<TaskOutcome> outcome;
    // Counted however often the task waits in between: two processes that take turns in failing
    // come to an end.
    for (int& tries = tries_[index]; tries < attempts_per_task;) {
      outcome = outcome_of(task, task_key, keys);
      if (!outcome || !outcome->is_transient || stop_.stop_requested()) break;
      if (++tries < attempts_per_task) std::this_thread::sleep_for(tries * pause_after_failure);
    }
    lock.lock();
    if (outcome) {
      end(index, *std::move(outcome));
    } else {
      claimed_elsewhere_.insert(index);
    }
  }

  /// Looks up or produces the products; nothing while another process holds the claim. Exceptions
  /// of a task do not leave this function.
  std::optional<TaskOutcome> outcome_of(const Task& task, const Hash& task_key,
                                        const std::vector<Hash>& keys) {
    try {
      if (auto present = present_products(task, keys))
        return with_products(TaskState::cached, *std::move(present));
      const std::unique_ptr<Claim> claim = store_.claim(task_key + " " + task.id);
      if (!claim) return std::nullopt;
      // Between the first look and the claim another process may have ended it.
      if (auto present = present_products(task, keys))
        return with_products(TaskState::cached, *std::move(present));
      note_damage(task, keys);
      make(task, task_key, keys);
      return with_products(TaskState::made, published(task, keys));
    } catch (const Interrupted&) {
      return without_products(TaskState::interrupted);
    } catch (const std::exception& error) {
      return failure(error, store_.folder());
    }
  }

  std::optional<std::vector<Receipt>> present_products(const Task& task,
                                                       const std::vector<Hash>& keys) const {
    if (task.products.empty()) return std::nullopt;
    return find_products(task, keys, store_.folder());
  }

  /// Records artifacts that were published before and have changed since.
  void note_damage(const Task& task, const std::vector<Hash>& keys) {
    for (std::size_t i = 0; i < task.products.size(); ++i) {
      const std::string& path = task.products[i].path;
      const auto receipt = read_receipt(store_.folder(), path);
      std::error_code none;
      const bool is_lost =
          !receipt && std::filesystem::is_regular_file(receipt_path(store_.folder(), path), none);
      const bool is_other = receipt && receipt->path != path;
      const bool is_damaged =
          receipt && receipt->key == keys[i] && !artifact_agrees(store_.folder(), *receipt);
      if (is_lost || is_other) store_.note_damage("the receipt of " + path);
      if (is_damaged) store_.note_damage(path);
    }
  }

  void make(const Task& task, const Hash& task_key, const std::vector<Hash>& keys) {
    notify([&] {
      if (observer_.started) observer_.started(task);
    });
    const auto progress = [&](double share) {
      store_.heartbeat().report_progress(task.id, share);
      notify([&] {
        if (observer_.progressed) observer_.progressed(task, share);
      });
    };
    store_.heartbeat().report_progress(task.id, 0.0);
    TaskRun task_run{store_, task, task_key, keys, stop_, progress};
    try {
      task.make(task_run);
    } catch (...) {
      store_.heartbeat().end_task(task.id);
      throw;
    }
    store_.heartbeat().end_task(task.id);
  }

  template <class Call>
  void notify(const Call& call) {
    const std::lock_guard guard(mutex_);
    call();
  }

  /// What `make` published. (The store has just verified and hashed it.)
  std::vector<Receipt> published(const Task& task, const std::vector<Hash>& keys) const {
    std::vector<Receipt> receipts;
    for (std::size_t i = 0; i < task.products.size(); ++i) {
      const std::string& path = task.products[i].path;
      auto receipt = read_receipt(store_.folder(), path);
      if (!receipt || receipt->key != keys[i]) throw WriteFailure(path + " was not made");
      receipts.push_back(std::move(*receipt));
    }
    return receipts;
  }

  const TaskGraph& graph_;
  Store& store_;
  std::stop_token stop_;
  const RunObserver& observer_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<TaskOutcome> outcomes_;
  std::vector<std::vector<std::size_t>> dependents_;  ///< of each task
  std::vector<std::size_t> awaited_;                  ///< inputs of each that have not ended
  std::vector<int> tries_;                   ///< of each that failed by the machine's fault
  std::set<std::size_t> ready_;              ///< whose inputs have ended
  std::set<std::size_t> claimed_elsewhere_;  ///< that other processes are making
  std::size_t ended_ = 0;
};

}  // namespace

std::vector<TaskOutcome> run(const TaskGraph& graph, Store& store, int jobs, std::stop_token stop,
                             const RunObserver& observer) {
  return Runner(graph, store, std::move(stop), observer).run(std::max(jobs, 1));
}

}  // namespace mien::pipeline
