#include "pipeline/tasks/store.h"

#include <algorithm>

#include "pipeline/base/documents/files.h"
#include "pipeline/tasks/disk_fault.h"
#include "pipeline/tasks/stale_files.h"
#include "pipeline/tasks/store_state.h"

namespace mien::pipeline {

namespace fs = std::filesystem;

std::string to_string(const Nondeterminism& met) {
  const auto by = [](const Hash& hash, const Maker& maker) {
    return hash + " on " + maker.host + " with " + maker.instruction_set;
  };
  return met.path + ": made twice from the same inputs with different bytes (" +
         by(met.before, met.before_by) + ", now " + by(met.now, met.now_by) +
         "); please report this";
}

Store::Store(const fs::path& folder, Sharing sharing) {
  try {
    state_ = std::make_unique<State>(folder, sharing);
  } catch (const StoreBusy&) {
    throw;
  } catch (const std::exception& error) {
    const std::string fault = disk_fault(folder, error);
    if (fault.empty()) throw;
    throw DiskFault(fault);
  }
}

Store::~Store() = default;

const fs::path& Store::folder() const { return state_->folder; }

std::optional<Receipt> Store::find(const std::string& path, const Hash& key) const {
  return find_artifact(state_->folder, path, key);
}

Receipt Store::put(const std::string& path, const Hash& key, const Write& write,
                   const Verify& verify) {
  Receipt receipt{key, path, "", 0, {}, state_->self()};
  state_->in_attempt([&](const fs::path& attempt) {
    const fs::path file = attempt / fs::path(path).filename();
    write(file);
    flush_to_disk(file);
    verify(file);
    receipt.hash = hash_of_file(file);
    receipt.size = fs::file_size(file);
    receipt = state_->publish(file, receipt);
  });
  return receipt;
}

std::unique_ptr<FrameStore> Store::frames(const std::string& path, const Hash& key) {
  return std::unique_ptr<FrameStore>(new FrameStore(*state_, path, key));
}

std::unique_ptr<Claim> Store::claim(const std::string& what) {
  return Claim::take(state_->folder, what, state_->worker(), state_->watch);
}

void Store::remove_intermediates() {
  pipeline::remove_intermediates(state_->folder, state_->heartbeat.file(), state_->worker());
}

WorkerHeartbeat& Store::heartbeat() { return state_->heartbeat; }

std::vector<Nondeterminism> Store::nondeterminism() const {
  const std::lock_guard guard(state_->mutex);
  std::vector<Nondeterminism> sorted = state_->nondeterminism;
  std::ranges::sort(sorted, {}, &Nondeterminism::path);
  return sorted;
}

void Store::note_damage(const std::string& path) {
  state_->note_repair(path +
                      ": was damaged, changed or removed after it was made, and is made again");
}

std::vector<std::string> Store::repairs() const {
  const std::lock_guard guard(state_->mutex);
  return {state_->repairs.begin(), state_->repairs.end()};
}

}  // namespace mien::pipeline
