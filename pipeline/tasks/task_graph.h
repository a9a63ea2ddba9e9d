#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/tasks/hash.h"
#include "pipeline/tasks/store.h"

namespace mien::pipeline {

/// An artifact produced by a task. Its key is built from the task's key and from determinants that
/// concern only this product, so that frames are not drawn again when a video setting changes.
struct Product {
  std::string path;  ///< path in the store
  KeyBuilder own;    ///< determinants beyond the task's
};

struct Task;

/// Context in which a task's function runs.
struct TaskRun {
  Store& store;
  const Task& task;
  Hash task_key;                         ///< key of the determinants common to all products
  std::vector<Hash> keys;                ///< one per product
  std::stop_token stop;                  ///< throw Interrupted soon after it is requested
  std::function<void(double)> progress;  ///< to be called with the share done, 0 … 1

  /// Produces one of the products (Store::put).
  void put(std::size_t product, const Store::Write& write, const Store::Verify& verify);

  /// Writes a text as one of the products; `verify` reads it back.
  void put_text(std::size_t product, const std::string& text, const Store::Verify& verify);
};

/// Thrown by a task that was asked to stop.
struct Interrupted {};

/// One part of a task that is split: the third of twelve parts is {3, 12}.
struct Part {
  int number = 1;
  int of = 1;

  friend bool operator==(const Part&, const Part&) = default;
};

/// Index range [first, end) of a part of `count` items. The parts together cover each item once.
std::pair<int, int> range_of(const Part& part, int count);

/// A step of a production, which produces all of its products.
struct Task {
  std::string id;                   ///< "film:target-1"
  std::string kind;                 ///< "film"
  std::vector<std::string> inputs;  ///< ids of tasks whose products it reads
  /// Ids of tasks that must have succeeded before, but whose products are not read.
  std::vector<std::string> after;
  KeyBuilder determinants;  ///< all common determinants of the products except the inputs' bytes
  /// Empty for a part (part_of), which is therefore always run; its `make` does only what remains
  /// to be done.
  std::vector<Product> products;
  double cost_seconds = 0.0;  ///< estimate on one core
  std::function<void(TaskRun&)> make;

  /// Does one part of the work; `make` reuses the results. Empty if the task cannot be split.
  std::function<void(TaskRun&, const Part&)> make_part;
};

/// Tasks ordered so that inputs come first.
struct TaskGraph {
  std::vector<Task> tasks;

  /// Adds a task. The tasks in `inputs` and `after` must have been added before.
  void add(Task task);
  const Task& task(const std::string& id) const;
  bool has(const std::string& id) const { return indices_.contains(id); }
  std::size_t index_of(const std::string& id) const;

 private:
  std::map<std::string, std::size_t> indices_;
};

enum class TaskState {
  cached,  ///< all products existed
  made,
  failed,   ///< the reason is in `error`
  skipped,  ///< a task in its `inputs` or `after` did not succeed
  interrupted,
  waiting,  ///< only in a plan: its inputs have to be produced first
  due,      ///< only in a plan: it has to be run
};

struct TaskOutcome {
  TaskState state = TaskState::waiting;
  std::string error;
  bool is_bad_input = false;      ///< failed because of the user's files
  bool is_transient = false;      ///< failed because of the machine; may succeed next time
  bool is_disk_fault = false;     ///< failed because the disk is full, read-only or unavailable
  std::vector<Receipt> products;  ///< receipts, if cached or made, in the task's order
};

/// Key of a whole graph: a hash of all determinants known before anything is run. The same for the
/// same manifest, quality, files, program, libraries and instruction set.
Hash key_of(const TaskGraph& graph);

/// Key of the determinants common to all products of a task, including the products of its input
/// tasks. `inputs`: the outcomes of these tasks.
Hash task_key_of(const Task& task, const std::vector<const TaskOutcome*>& inputs);

/// Keys of a task's products, given the task's key.
std::vector<Hash> product_keys(const Task& task, const Hash& task_key);

/// Keys of a task's products, given the outcomes of its input tasks.
std::vector<Hash> keys_of(const Task& task, const std::vector<const TaskOutcome*>& inputs);

/// The receipts of a task's products if all of them are present with these keys.
std::optional<std::vector<Receipt>> find_products(const Task& task, const std::vector<Hash>& keys,
                                                  const std::filesystem::path& folder);

/// Determines which tasks are cached, due or waiting, without running any. Reads and hashes
/// existing products. One outcome per task.
std::vector<TaskOutcome> plan(const TaskGraph& graph, const std::filesystem::path& folder);

/// A fast `plan`, based on receipts and file sizes and, for frames, on the existence of their
/// folder; no artifact is read. Damage that leaves a file's size unchanged, and any damage to
/// frames in an existing folder, is only detected by `plan` and `run`.
std::vector<TaskOutcome> quick_plan(const TaskGraph& graph, const std::filesystem::path& folder);

/// Callbacks during a run; called from several threads, one call at a time.
struct RunObserver {
  std::function<void(const Task&)> started;
  std::function<void(const Task&, double share)> progressed;
  std::function<void(const Task&, const TaskOutcome&)> ended;
};

/// A part of a task, as a task "film:a[3/12]" without products. `whole` must have make_part and
/// outlive the result.
Task part_of(const Task& whole, const Part& part);

/// Runs the tasks on `jobs` threads. Tasks claimed by other processes in the same store are left to
/// them, and run here if those processes die or do not complete them. After a transient failure,
/// the task is run again, at most three times in total. If a task fails, tasks that depend on it
/// are skipped; all others continue. After a stop request no further task is started. One outcome
/// per task.
std::vector<TaskOutcome> run(const TaskGraph& graph, Store& store, int jobs, std::stop_token stop,
                             const RunObserver& observer);

}  // namespace mien::pipeline
