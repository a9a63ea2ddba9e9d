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

/// An artifact that a task makes. Its key is made of the task's key and of what concerns this
/// product alone, so that another video setting does not draw the frames again.
struct Product {
  std::string path;  ///< in the store
  KeyBuilder own;    ///< determinants beyond the task's
};

struct Task;

/// What a task's function is given.
struct TaskRun {
  Store& store;
  const Task& task;
  Hash task_key;                         ///< of what all products have in common
  std::vector<Hash> keys;                ///< one a product
  std::stop_token stop;                  ///< throw Interrupted soon after it is requested
  std::function<void(double)> progress;  ///< share done, 0 … 1

  /// Makes one of the products (Store::put).
  void put(std::size_t product, const Store::Write& write, const Store::Verify& verify);

  /// One that is a text, which `verify` reads back.
  void put_text(std::size_t product, const std::string& text, const Store::Verify& verify);
};

/// Thrown by a task that was asked to stop.
struct Interrupted {};

/// Of a task that is made in parts: the third of twelve is {3, 12}.
struct Part {
  int number = 1;
  int of = 1;

  friend bool operator==(const Part&, const Part&) = default;
};

/// Of so many things that are made in parts: the first of a part, and the one after its last. All
/// parts together hold each once.
std::pair<int, int> range_of(const Part& part, int count);

/// A step of a production: makes all of its products.
struct Task {
  std::string id;                   ///< "film:target-1"
  std::string kind;                 ///< "film"
  std::vector<std::string> inputs;  ///< ids of tasks whose products it reads
  std::vector<std::string> after;   ///< likewise tasks that must not have failed, and no more
  KeyBuilder determinants;          ///< all that determines the products beside the inputs' bytes
  std::vector<Product> products;    ///< none of a part: it is begun, and finds out what is missing
  double cost_seconds = 0.0;        ///< estimate on one core
  std::function<void(TaskRun&)> make;

  /// Of a task that can be made in parts: does so much of the work that `make` finds it done.
  std::function<void(TaskRun&, const Part&)> make_part;
};

/// Tasks in an order in which inputs come first.
struct TaskGraph {
  std::vector<Task> tasks;

  /// Adds a task. Its inputs, and what it comes after, must have been added before.
  void add(Task task);
  const Task& task(const std::string& id) const;
  bool has(const std::string& id) const { return indices_.contains(id); }
  std::size_t index_of(const std::string& id) const;

 private:
  std::map<std::string, std::size_t> indices_;
};

enum class TaskState {
  cached,  ///< all products were there
  made,
  failed,   ///< `error` says why
  skipped,  ///< an input failed or was interrupted
  interrupted,
  waiting,  ///< in a plan: its inputs have to be made first
  due,      ///< in a plan: has to be made
};

struct TaskOutcome {
  TaskState state = TaskState::waiting;
  std::string error;
  bool is_bad_input = false;      ///< failed through the user's files, not the machine
  bool is_transient = false;      ///< failed through the machine, and may not the next time
  bool is_disk_fault = false;     ///< likewise: the disk is full, read-only or away
  std::vector<Receipt> products;  ///< when cached or made, in the task's order
};

/// Of all that its tasks determine before anything is made: the same for the same manifest, files,
/// program, libraries and instruction set.
Hash key_of(const TaskGraph& graph);

/// What all products of a task depend on, once all inputs' products are known.
Hash task_key_of(const Task& task, const std::vector<const TaskOutcome*>& inputs);

/// Keys of a task's products.
std::vector<Hash> product_keys(const Task& task, const Hash& task_key);

/// Likewise, once all inputs' products are known.
std::vector<Hash> keys_of(const Task& task, const std::vector<const TaskOutcome*>& inputs);

/// The products' receipts when all of them are present with these keys.
std::optional<std::vector<Receipt>> find_products(const Task& task, const std::vector<Hash>& keys,
                                                  const std::filesystem::path& folder);

/// What a run would do: which tasks are cached, due or waiting. Reads all that is there to tell.
/// One outcome a task.
std::vector<TaskOutcome> plan(const TaskGraph& graph, const std::filesystem::path& folder);

/// The same at a glance: goes by receipts and the sizes of files, of which no byte is read, and of
/// frames by their folder. What was damaged and kept its size is seen by `plan` and `run` alone.
std::vector<TaskOutcome> glance(const TaskGraph& graph, const std::filesystem::path& folder);

/// Told about what happens; called from several threads, one call at a time.
struct RunObserver {
  std::function<void(const Task&)> started;
  std::function<void(const Task&, double share)> progressed;
  std::function<void(const Task&, const TaskOutcome&)> ended;
};

/// A part of a task, as a task "film:a[3/12]" without products. `whole` has make_part and outlives
/// it.
Task part_of(const Task& whole, const Part& part);

/// Runs the tasks on `jobs` threads. What other processes are making in the same store is left to
/// them, and made here if they die. A task that fails by the machine's fault is tried again, thrice
/// in all; one that fails leaves the others running, and what depends on it is skipped. After
/// `stop` no task is begun. One outcome a task.
std::vector<TaskOutcome> run(const TaskGraph& graph, Store& store, int jobs, std::stop_token stop,
                             const RunObserver& observer);

}  // namespace mien::pipeline
