#include "pipeline/farm/glance.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include <sys/stat.h>

namespace mien::pipeline {

namespace {

/// Whether something is where the receipt says, of the size that it says.
bool seems_there(const Receipt& receipt, const std::filesystem::path& folder) {
  struct stat found = {};
  if (::stat((folder / receipt.path).c_str(), &found) != 0) return false;
  if (!receipt.frames.empty()) return S_ISDIR(found.st_mode);
  return S_ISREG(found.st_mode) && static_cast<std::uint64_t>(found.st_size) == receipt.size;
}

std::optional<std::vector<Receipt>> products_seen(const Task& task, const std::vector<Hash>& keys,
                                                  const std::filesystem::path& folder) {
  std::vector<Receipt> receipts;
  for (std::size_t i = 0; i < task.products.size(); ++i) {
    std::optional<Receipt> receipt = read_receipt(folder, task.products[i].path);
    if (!receipt || receipt->key != keys[i] || !seems_there(*receipt, folder)) return std::nullopt;
    receipts.push_back(std::move(*receipt));
  }
  return receipts;
}

}  // namespace

std::vector<TaskOutcome> glance(const TaskGraph& graph, const std::filesystem::path& folder) {
  std::vector<TaskOutcome> outcomes(graph.tasks.size());
  for (std::size_t i = 0; i < graph.tasks.size(); ++i) {
    const Task& task = graph.tasks[i];
    std::vector<const TaskOutcome*> inputs;
    for (const std::string& id : task.inputs) inputs.push_back(&outcomes[graph.index_of(id)]);
    const bool are_there = std::all_of(inputs.begin(), inputs.end(), [](const TaskOutcome* one) {
      return one->state == TaskState::cached;
    });
    if (!are_there) continue;
    auto receipts = products_seen(task, keys_of(task, inputs), folder);
    outcomes[i].state = receipts ? TaskState::cached : TaskState::due;
    if (receipts) outcomes[i].products = std::move(*receipts);
  }
  return outcomes;
}

}  // namespace mien::pipeline
