#include "pipeline/tasks/task_graph.h"

#include <algorithm>
#include <cassert>
#include <optional>
#include <utility>

namespace mien::pipeline {

namespace {

std::vector<const TaskOutcome*> inputs_of(const TaskGraph& graph, const Task& task,
                                          const std::vector<TaskOutcome>& outcomes) {
  std::vector<const TaskOutcome*> inputs;
  for (const std::string& id : task.inputs) inputs.push_back(&outcomes[graph.index_of(id)]);
  return inputs;
}

}  // namespace

void TaskGraph::add(Task task) {
  assert(!task.products.empty());
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

std::vector<Hash> keys_of(const Task& task, const std::vector<const TaskOutcome*>& inputs) {
  KeyBuilder builder = task.determinants;
  builder.add("kind", task.kind);
  for (const TaskOutcome* input : inputs) {
    for (const Receipt& product : input->products) builder.add(product.path, product.hash);
  }
  const Hash shared = builder.key();
  std::vector<Hash> keys;
  for (const Product& product : task.products) {
    KeyBuilder own = product.own;
    keys.push_back(own.add("path", product.path).add("task", shared).key());
  }
  return keys;
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

std::vector<TaskOutcome> plan(const TaskGraph& graph, const std::filesystem::path& folder) {
  std::vector<TaskOutcome> outcomes(graph.tasks.size());
  for (std::size_t i = 0; i < graph.tasks.size(); ++i) {
    const Task& task = graph.tasks[i];
    const auto inputs = inputs_of(graph, task, outcomes);
    const auto is_cached = [](const TaskOutcome* input) {
      return input->state == TaskState::cached;
    };
    if (!std::all_of(inputs.begin(), inputs.end(), is_cached)) continue;
    auto receipts = find_products(task, keys_of(task, inputs), folder);
    outcomes[i].state = receipts ? TaskState::cached : TaskState::due;
    if (receipts) outcomes[i].products = std::move(*receipts);
  }
  return outcomes;
}

}  // namespace mien::pipeline
