#include "pipeline/tasks/store.h"

#include <algorithm>
#include <utility>

#include "pipeline/documents/files.h"
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

Store::Store(fs::path folder, Sharing sharing)
    : state_(std::make_unique<State>(std::move(folder), sharing)) {}

Store::~Store() = default;

const fs::path& Store::folder() const { return state_->folder; }

std::optional<Receipt> Store::find(const std::string& path, const Hash& key) const {
  return find_artifact(state_->folder, path, key);
}

Receipt Store::put(const std::string& path, const Hash& key, const Write& write,
                   const Verify& verify) {
  const fs::path attempt = state_->new_attempt();
  const fs::path file = attempt / fs::path(path).filename();
  write(file);
  flush_to_disk(file);
  verify(file);
  Receipt receipt{key, path, hash_of_file(file), fs::file_size(file), {}, state_->self()};
  receipt = state_->publish(file, std::move(receipt));
  fs::remove_all(attempt);
  return receipt;
}

std::unique_ptr<FrameStore> Store::frames(const std::string& path, const Hash& key) {
  return std::unique_ptr<FrameStore>(new FrameStore(*state_, path, key));
}

std::unique_ptr<Claim> Store::claim(const std::string& what) {
  return Claim::take(state_->folder, what, state_->worker(), state_->watch);
}

WorkerPresence& Store::presence() { return state_->presence; }

std::vector<Nondeterminism> Store::nondeterminism() const {
  const std::lock_guard guard(state_->mutex);
  std::vector<Nondeterminism> sorted = state_->nondeterminism;
  std::ranges::sort(sorted, {}, &Nondeterminism::path);
  return sorted;
}

void Store::note_damage(const std::string& path) {
  state_->note_repair(path +
                      ": was damaged, changed or removed since it was made, and is made again");
}

std::vector<std::string> Store::repairs() const {
  const std::lock_guard guard(state_->mutex);
  return {state_->repairs.begin(), state_->repairs.end()};
}

}  // namespace mien::pipeline
