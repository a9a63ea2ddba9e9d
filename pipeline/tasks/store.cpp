#include "pipeline/tasks/store.h"

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include "pipeline/documents/files.h"
#include "pipeline/tasks/store_state.h"

namespace mien::pipeline {

namespace fs = std::filesystem;

Store::State::State(fs::path at) : folder(std::move(at)) {
  make_folder(internal());
  const fs::path file = internal() / "lock";
  lock = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (lock < 0) throw std::system_error(errno, std::generic_category(), file.string());
  if (::flock(lock, LOCK_EX | LOCK_NB) != 0) {
    ::close(lock);
    throw StoreBusy("another run is working in " + folder.string() +
                    "; wait for it to end, or choose another folder with --out");
  }
  fs::remove_all(internal() / "attempts");
}

Store::State::~State() { ::close(lock); }

fs::path Store::State::new_attempt() {
  const fs::path attempt =
      internal() / "attempts" / (std::to_string(::getpid()) + "-" + std::to_string(++attempts));
  fs::create_directories(attempt);
  return attempt;
}

void Store::State::write_receipt(const Receipt& receipt) {
  const fs::path attempt = new_attempt();
  write_file(attempt / "receipt", to_json(receipt));
  flush_to_disk(attempt / "receipt");
  const fs::path target = receipt_path(folder, receipt.path);
  fs::create_directories(target.parent_path());
  fs::rename(attempt / "receipt", target);
  flush_to_disk(target.parent_path());
  fs::remove_all(attempt);
}

void Store::State::compare(const std::string& path, const Hash& before, const Hash& now) {
  if (before == now) return;
  const std::lock_guard guard(mutex);
  nondeterminism.push_back({path, before, now});
}

Store::Store(fs::path folder) : state_(std::make_unique<State>(std::move(folder))) {}

Store::~Store() = default;

const fs::path& Store::folder() const { return state_->folder; }

std::optional<Receipt> Store::find(const std::string& path, const Hash& key) const {
  return find_artifact(state_->folder, path, key);
}

Receipt Store::put(const std::string& path, const Hash& key, const Write& write,
                   const Verify& verify) {
  const fs::path target = state_->folder / path;
  const fs::path attempt = state_->new_attempt();
  const fs::path file = attempt / target.filename();
  write(file);
  flush_to_disk(file);
  verify(file);
  const Receipt receipt{key, path, hash_of_file(file), fs::file_size(file), {}};

  const std::optional<Receipt> before = read_receipt(state_->folder, path);
  if (before && before->key == key) state_->compare(path, before->hash, receipt.hash);
  fs::create_directories(target.parent_path());
  if (fs::is_directory(target)) fs::remove_all(target);
  fs::rename(file, target);
  flush_to_disk(target.parent_path());
  state_->write_receipt(receipt);
  fs::remove_all(attempt);
  return receipt;
}

std::unique_ptr<FrameStore> Store::frames(const std::string& path, const Hash& key) {
  return std::unique_ptr<FrameStore>(new FrameStore(*state_, path, key));
}

std::vector<Nondeterminism> Store::nondeterminism() const {
  const std::lock_guard guard(state_->mutex);
  std::vector<Nondeterminism> sorted = state_->nondeterminism;
  std::sort(sorted.begin(), sorted.end(),
            [](const auto& left, const auto& right) { return left.path < right.path; });
  return sorted;
}

}  // namespace mien::pipeline
