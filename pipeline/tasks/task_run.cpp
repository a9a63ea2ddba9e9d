#include <algorithm>
#include <condition_variable>
#include <exception>
#include <filesystem>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>

#include "motion/error.h"
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

/// A message without the folders of attempts, which are gone when somebody reads it.
std::string without_attempts(std::string text, const std::filesystem::path& folder) {
  const std::string attempts = (folder / ".mien" / "attempts").string() + "/";
  for (std::size_t at = text.find(attempts); at != std::string::npos; at = text.find(attempts)) {
    const std::size_t end = text.find('/', at + attempts.size());
    text.erase(at, end == std::string::npos ? attempts.size() : end + 1 - at);
  }
  return text;
}

TaskOutcome failure(const std::exception& error, bool is_bad_input,
                    const std::filesystem::path& folder) {
  TaskOutcome outcome = without_products(TaskState::failed);
  outcome.error = without_attempts(error.what(), folder);
  outcome.is_bad_input = is_bad_input;
  return outcome;
}

/// Worker threads that take tasks in graph order as soon as their inputs are there.
class Runner {
 public:
  Runner(const TaskGraph& graph, Store& store, std::stop_token stop, const RunObserver& observer)
      : graph_(graph),
        store_(store),
        stop_(std::move(stop)),
        observer_(observer),
        outcomes_(graph.tasks.size()),
        begun_(graph.tasks.size(), false) {}

  std::vector<TaskOutcome> run(int jobs) {
    {
      std::vector<std::jthread> workers;
      for (int i = 0; i < jobs; ++i) workers.emplace_back([this] { work(); });
    }
    return std::move(outcomes_);
  }

 private:
  enum class Readiness { never, not_yet, ready };

  void work() {
    std::unique_lock lock(mutex_);
    while (ended_ < graph_.tasks.size()) {
      if (const auto next = take_next()) {
        perform(*next, lock);
      } else if (ended_ < graph_.tasks.size()) {
        changed_.wait(lock);
      }
    }
  }

  static bool has_products(const TaskOutcome& outcome) {
    return outcome.state == TaskState::cached || outcome.state == TaskState::made;
  }

  Readiness readiness_after(const std::vector<std::string>& tasks) const {
    Readiness result = Readiness::ready;
    for (const std::string& id : tasks) {
      const TaskOutcome& outcome = outcomes_[graph_.index_of(id)];
      if (outcome.state == TaskState::waiting) {
        result = Readiness::not_yet;
      } else if (!has_products(outcome)) {
        return Readiness::never;
      }
    }
    return result;
  }

  Readiness readiness(const Task& task) const {
    return std::min(readiness_after(task.inputs), readiness_after(task.after));
  }

  /// Ends what cannot be begun any more and takes the first task that can.
  std::optional<std::size_t> take_next() {
    for (std::size_t i = 0; i < graph_.tasks.size(); ++i) {
      if (begun_[i]) continue;
      const Readiness ready = readiness(graph_.tasks[i]);
      if (ready == Readiness::not_yet) continue;
      begun_[i] = true;
      if (ready == Readiness::ready && !stop_.stop_requested()) return i;
      const bool is_blocked = ready == Readiness::never;
      end(i, without_products(is_blocked ? TaskState::skipped : TaskState::interrupted));
    }
    return std::nullopt;
  }

  void end(std::size_t index, TaskOutcome outcome) {
    outcomes_[index] = std::move(outcome);
    ++ended_;
    if (observer_.ended) observer_.ended(graph_.tasks[index], outcomes_[index]);
    changed_.notify_all();
  }

  void perform(std::size_t index, std::unique_lock<std::mutex>& lock) {
    const Task& task = graph_.tasks[index];
    std::vector<const TaskOutcome*> inputs;
    for (const std::string& id : task.inputs) inputs.push_back(&outcomes_[graph_.index_of(id)]);
    const std::vector<Hash> keys = keys_of(task, inputs);
    lock.unlock();
    TaskOutcome outcome = outcome_of(task, keys);
    lock.lock();
    end(index, std::move(outcome));
  }

  /// Looks the products up or makes them. No exception of a task gets past here.
  TaskOutcome outcome_of(const Task& task, const std::vector<Hash>& keys) {
    try {
      if (auto present = find_products(task, keys, store_.folder())) {
        return with_products(TaskState::cached, std::move(*present));
      }
      make(task, keys);
      return with_products(TaskState::made, published(task, keys));
    } catch (const Interrupted&) {
      return without_products(TaskState::interrupted);
    } catch (const Error& error) {
      return failure(error, true, store_.folder());
    } catch (const std::exception& error) {
      return failure(error, false, store_.folder());
    }
  }

  void make(const Task& task, const std::vector<Hash>& keys) {
    notify([&] {
      if (observer_.started) observer_.started(task);
    });
    const auto progress = [&](double share) {
      notify([&] {
        if (observer_.progressed) observer_.progressed(task, share);
      });
    };
    TaskRun task_run{store_, task, keys, stop_, progress};
    task.make(task_run);
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
      if (!receipt || receipt->key != keys[i]) throw std::logic_error(path + " was not made");
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
  std::vector<bool> begun_;
  std::size_t ended_ = 0;
};

}  // namespace

std::vector<TaskOutcome> run(const TaskGraph& graph, Store& store, int jobs, std::stop_token stop,
                             const RunObserver& observer) {
  return Runner(graph, store, std::move(stop), observer).run(std::max(jobs, 1));
}

}  // namespace mien::pipeline
