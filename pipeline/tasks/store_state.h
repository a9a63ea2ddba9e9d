#pragma once

#include <atomic>
#include <filesystem>
#include <mutex>
#include <string>
#include <vector>

#include "pipeline/tasks/store.h"

namespace mien::pipeline {

/// What a Store and its FrameStores share.
struct Store::State {
  /// Takes the lock; it is given back when the object (or the process) ends.
  explicit State(std::filesystem::path at);
  ~State();
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  std::filesystem::path internal() const { return folder / ".mien"; }

  /// A new empty folder that no other attempt uses.
  std::filesystem::path new_attempt();

  void write_receipt(const Receipt& receipt);

  /// Notes nondeterminism when the hashes differ.
  void compare(const std::string& path, const Hash& before, const Hash& now);

  std::filesystem::path folder;
  int lock = -1;
  std::atomic<int> attempts = 0;
  mutable std::mutex mutex;
  std::vector<Nondeterminism> nondeterminism;
};

}  // namespace mien::pipeline
