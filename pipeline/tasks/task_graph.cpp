#include "pipeline/tasks/task_graph.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <system_error>

#include "pipeline/base/documents/files.h"

namespace mien::pipeline {

namespace {

std::vector<const TaskOutcome*> inputs_of(const TaskGraph& graph, const Task& task,
                                          const std::vector<TaskOutcome>& outcomes) {
  std::vector<const TaskOutcome*> inputs;
  for (const std::string& id : task.inputs) inputs.push_back(&outcomes[graph.index_of(id)]);
  return inputs;
}

/// Frames are not counted: a study may have millions.
bool seems_present(const std::filesystem::path& folder, const Receipt& receipt) {
  std::error_code error;
  return receipt.frames.empty() ? artifact_seems_present(folder, receipt)
                                : std::filesystem::is_directory(folder / receipt.path, error);
}

/// The products' receipts when all of them seem to be there with these keys.
std::optional<std::vector<Receipt>> quickly_found_products(const Task& task,
                                                           const std::vector<Hash>& keys,
                                                           const std::filesystem::path& folder) {
  std::vector<Receipt> receipts;
  for (std::size_t i = 0; i < task.products.size(); ++i) {
    std::optional<Receipt> receipt = read_receipt(folder, task.products[i].path);
    if (!receipt || receipt->key != keys[i] || receipt->path != task.products[i].path ||
        !seems_present(folder, *receipt))
      return std::nullopt;
    receipts.push_back(std::move(*receipt));
  }
  return receipts;
}

/// One outcome per task; `find` looks up its products.
template <class Find>
std::vector<TaskOutcome> outcomes_by(const Find& find, const TaskGraph& graph,
                                     const std::filesystem::path& folder) {
  std::vector<TaskOutcome> outcomes(graph.tasks.size());
  for (std::size_t i = 0; i < graph.tasks.size(); ++i) {
    const Task& task = graph.tasks[i];
    const auto inputs = inputs_of(graph, task, outcomes);
    const auto is_cached = [](const TaskOutcome* input) {
      return input->state == TaskState::cached;
    };
    if (!std::all_of(inputs.begin(), inputs.end(), is_cached)) continue;
    auto receipts = find(task, keys_of(task, inputs), folder);
    outcomes[i].state = receipts ? TaskState::cached : TaskState::due;
    if (receipts) outcomes[i].products = std::move(*receipts);
  }
  return outcomes;
}

}  // namespace

void TaskRun::put(std::size_t product, const Store::Write& write, const Store::Verify& verify) {
  store.put(task.products[product].path, keys[product], write, verify);
}

void TaskRun::put_text(std::size_t product, const std::string& text, const Store::Verify& verify) {
  put(
      product, [&](const std::filesystem::path& file) { write_file(file, text); }, verify);
}

void TaskGraph::add(Task task) {
  assert(std::all_of(task.inputs.begin(), task.inputs.end(),
                     [&](const std::string& input) { return indices_.contains(input); }));
  assert(std::all_of(task.after.begin(), task.after.end(),
                     [&](const std::string& earlier) { return indices_.contains(earlier); }));
  assert(!indices_.contains(task.id));
  indices_.emplace(task.id, tasks.size());
  tasks.push_back(std::move(task));
}

const Task& TaskGraph::task(const std::string& id) const { return tasks[index_of(id)]; }

std::size_t TaskGraph::index_of(const std::string& id) const { return indices_.at(id); }

std::pair<int, int> range_of(const Part& part, int count) {
  const auto border = [&](std::int64_t number) {
    return static_cast<int>(number * count / part.of);
  };
  return {border(part.number - 1), border(part.number)};
}

Hash key_of(const TaskGraph& graph) {
  KeyBuilder key;
  for (const Task& task : graph.tasks) {
    key.add(task.id, task.determinants.key());
    for (const Product& product : task.products) key.add(product.path, product.own.key());
  }
  return key.key();
}

Hash task_key_of(const Task& task, const std::vector<const TaskOutcome*>& inputs) {
  KeyBuilder builder = task.determinants;
  builder.add("kind", task.kind);
  for (const TaskOutcome* input : inputs) {
    for (const Receipt& product : input->products) builder.add(product.path, product.hash);
  }
  return builder.key();
}

std::vector<Hash> product_keys(const Task& task, const Hash& task_key) {
  std::vector<Hash> keys;
  for (const Product& product : task.products) {
    KeyBuilder own = product.own;
    keys.push_back(own.add("path", product.path).add("task", task_key).key());
  }
  return keys;
}

std::vector<Hash> keys_of(const Task& task, const std::vector<const TaskOutcome*>& inputs) {
  return product_keys(task, task_key_of(task, inputs));
}

std::optional<std::vector<Receipt>> find_products(const Task& task, const std::vector<Hash>& keys,
                                                  const std::filesystem::path& folder) {
  std::vector<Receipt> receipts;
  for (std::size_t i = 0; i < task.products.size(); ++i) {
    auto receipt = find_artifact(folder, task.products[i].path, keys[i]);
    if (!receipt) return std::nullopt;
    receipts.push_back(std::move(*receipt));
  }
  return receipts;
}

Task part_of(const Task& whole, const Part& part) {
  assert(whole.make_part);
  Task task;
  task.id = whole.id + "[" + std::to_string(part.number) + "/" + std::to_string(part.of) + "]";
  task.kind = whole.kind;
  task.inputs = whole.inputs;
  task.after = whole.after;
  task.determinants = whole.determinants;
  task.cost_seconds = whole.cost_seconds / part.of;
  task.make = [&whole, part](TaskRun& run) {
    TaskRun whole_run{run.store, whole,       run.task_key, product_keys(whole, run.task_key),
                      run.stop,  run.progress};
    if (!find_products(whole, whole_run.keys, run.store.folder())) whole.make_part(whole_run, part);
  };
  return task;
}

std::vector<TaskOutcome> plan(const TaskGraph& graph, const std::filesystem::path& folder) {
  return outcomes_by(find_products, graph, folder);
}

std::vector<TaskOutcome> quick_plan(const TaskGraph& graph, const std::filesystem::path& folder) {
  return outcomes_by(quickly_found_products, graph, folder);
}

}  // namespace mien::pipeline
