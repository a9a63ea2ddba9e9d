#include "pipeline/farm/glance.h"

#include <algorithm>
#include <atomic>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>

#include <sys/stat.h>

namespace mien::pipeline {

namespace {

using Receipts = std::vector<std::optional<Receipt>>;

// More than there are processors: on a shared file system a look takes its time, not theirs.
constexpr std::size_t lookers = 16;

/// Whether something is where the receipt says, of the size that it says.
bool seems_there(const Receipt& receipt, const std::filesystem::path& folder) {
  struct stat found = {};
  if (::stat((folder / receipt.path).c_str(), &found) != 0) return false;
  if (!receipt.frames.empty()) return S_ISDIR(found.st_mode);
  return S_ISREG(found.st_mode) && static_cast<std::uint64_t>(found.st_size) == receipt.size;
}

/// What cannot be read counts as not there.
std::optional<Receipt> receipt_seen(const Product& product, const std::filesystem::path& folder) {
  try {
    std::optional<Receipt> receipt = read_receipt(folder, product.path);
    if (receipt && seems_there(*receipt, folder)) return receipt;
  } catch (const std::runtime_error&) {
  }
  return std::nullopt;
}

/// Of a task's products.
Receipts receipts_of(const Task& task, const std::filesystem::path& folder) {
  Receipts receipts;
  for (const Product& product : task.products) {
    receipts.push_back(receipt_seen(product, folder));
  }
  return receipts;
}

/// Of each task. Before the first run there is no folder to look into.
std::vector<Receipts> all_receipts(const TaskGraph& graph, const std::filesystem::path& folder) {
  std::vector<Receipts> receipts(graph.tasks.size());
  std::error_code error;
  if (!std::filesystem::is_directory(folder / ".mien" / "receipts", error)) return receipts;
  std::atomic<std::size_t> next = 0;
  const auto look = [&] {
    for (std::size_t i = next++; i < receipts.size(); i = next++) {
      receipts[i] = receipts_of(graph.tasks[i], folder);
    }
  };
  std::vector<std::jthread> threads;
  for (std::size_t i = 0; i < std::min(lookers, receipts.size()); ++i) threads.emplace_back(look);
  threads.clear();
  return receipts;
}

bool have_keys(const Receipts& receipts, const std::vector<Hash>& keys) {
  if (receipts.size() != keys.size()) return false;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (!receipts[i] || receipts[i]->key != keys[i]) return false;
  }
  return true;
}

}  // namespace

std::vector<TaskOutcome> glance(const TaskGraph& graph, const std::filesystem::path& folder) {
  std::vector<Receipts> receipts = all_receipts(graph, folder);
  std::vector<TaskOutcome> outcomes(graph.tasks.size());
  for (std::size_t i = 0; i < graph.tasks.size(); ++i) {
    const Task& task = graph.tasks[i];
    std::vector<const TaskOutcome*> inputs;
    for (const std::string& id : task.inputs) inputs.push_back(&outcomes[graph.index_of(id)]);
    const bool are_there = std::all_of(inputs.begin(), inputs.end(), [](const TaskOutcome* one) {
      return one->state == TaskState::cached;
    });
    if (!are_there) continue;
    const bool is_there = have_keys(receipts[i], keys_of(task, inputs));
    outcomes[i].state = is_there ? TaskState::cached : TaskState::due;
    if (!is_there) continue;
    for (std::optional<Receipt>& receipt : receipts[i]) {
      outcomes[i].products.push_back(std::move(*receipt));
    }
  }
  return outcomes;
}

}  // namespace mien::pipeline
