#include "pipeline/tasks/store_state.h"

#include <cerrno>
#include <system_error>
#include <utility>

#include "pipeline/documents/files.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

/// A process of another machine that was silent for so long does nothing any more, or will find
/// that its attempts are gone.
constexpr double dead_after_seconds = 24.0 * 3600.0;
constexpr double silent_after_seconds = 60.0;
constexpr int tries_to_publish = 100;  ///< against others that publish in the same place

/// Whether a process works now, judged at once.
bool works_now(const fs::path& folder, const WorkerRecord& record, const fs::path& now) {
  return !is_gone(record) && seconds_silent(folder, record, now) < silent_after_seconds;
}

/// Whether it is certain, or as good as certain, that a process will do nothing any more.
bool is_dead(const fs::path& folder, const WorkerRecord& record, const fs::path& now) {
  return is_gone(record) || seconds_silent(folder, record, now) > dead_after_seconds;
}

}  // namespace

Store::State::State(fs::path at, Sharing sharing)
    : folder(std::move(at)), presence(folder, sharing == Sharing::exclusive), watch(folder) {
  refuse_company(sharing);
  remove_what_the_dead_left();
}

Store::State::~State() {
  std::error_code ignored;
  fs::remove_all(internal() / "attempts" / worker(), ignored);
}

/// Each process shows itself before it looks at the others, so that of two that come at the same
/// moment at least one sees the other.
void Store::State::refuse_company(Sharing sharing) {
  for (const WorkerRecord& other : read_worker_records(folder)) {
    if (other.name == worker() || !works_now(folder, other, presence.file())) continue;
    if (sharing == Sharing::shared && !other.exclusive) continue;
    throw StoreBusy("another process works in " + folder.string() + " (number " +
                    std::to_string(other.process) + " on " + other.host +
                    "); wait for it to end, or choose another folder with --out");
  }
}

/// Attempts lie in a folder with the name of the process, whose record was there before.
void Store::State::remove_what_the_dead_left() {
  std::error_code ignored;
  for (const fs::directory_entry& entry :
       fs::directory_iterator(internal() / "attempts", ignored)) {
    const std::string name = entry.path().filename();
    const std::optional<WorkerRecord> record = read_worker_record(folder, name);
    if (!record || is_dead(folder, *record, presence.file())) fs::remove_all(entry.path(), ignored);
  }
  for (const WorkerRecord& other : read_worker_records(folder)) {
    if (other.ended || other.frames > 0 || !is_dead(folder, other, presence.file())) continue;
    fs::remove(worker_record_path(folder, other.name), ignored);
  }
}

fs::path Store::State::new_attempt() {
  const fs::path attempt = internal() / "attempts" / worker() / std::to_string(++attempts);
  fs::create_directories(attempt);
  return attempt;
}

Receipt Store::State::publish(const fs::path& attempt, Receipt receipt) {
  if (auto before = published_before(receipt)) {
    compare(receipt.path, before->hash, before->maker, receipt.hash);
    return *std::move(before);
  }
  if (const auto before = read_receipt(folder, receipt.path);
      before && before->path == receipt.path && before->key == receipt.key)
    compare(receipt.path, before->hash, before->maker, receipt.hash);
  move_into_place(attempt, receipt);
  write_receipt(receipt);
  return receipt;
}

std::optional<Receipt> Store::State::published_before(const Receipt& receipt) const {
  return find_artifact(folder, receipt.path, receipt.key);
}

void Store::State::move_into_place(const fs::path& attempt, const Receipt& receipt) {
  const fs::path target = folder / receipt.path;
  const bool is_folder = !receipt.frames.empty();
  for (int tries = 1;; ++tries) {
    make_way(receipt.path, is_folder);
    if (is_folder && fs::exists(target)) {  // no folder takes the place of one that is not empty
      const fs::path away = new_attempt();
      std::error_code gone;  // another process may have been faster
      fs::rename(target, away / "replaced", gone);
      fs::remove_all(away);
    }
    std::error_code error;
    fs::rename(attempt, target, error);
    if (!error) break;
    const bool has_rival = error == std::errc::directory_not_empty ||
                           error == std::errc::file_exists || error == std::errc::is_a_directory ||
                           error == std::errc::no_such_file_or_directory;
    if (!has_rival || tries == tries_to_publish || !fs::exists(attempt))
      throw fs::filesystem_error("cannot be put in its place", target, error);
  }
  flush_to_disk(target.parent_path());
}

void Store::State::write_receipt(const Receipt& receipt) {
  const fs::path attempt = new_attempt();
  write_file(attempt / "receipt", to_json(receipt));
  flush_to_disk(attempt / "receipt");
  const fs::path target = receipt_path(folder, receipt.path);
  make_way(target.lexically_relative(folder).generic_string(), false);
  fs::rename(attempt / "receipt", target);
  flush_to_disk(target.parent_path());
  fs::remove_all(attempt);
}

/// Makes the folders above an artifact. What is no folder where one has to be, or in the artifact's
/// own place neither a file nor a sequence of frames, is set aside.
void Store::State::make_way(const std::string& path, bool for_folder) {
  std::error_code error;
  fs::path above = folder;
  for (const fs::path& part : fs::path(path).parent_path()) {
    above /= part;
    fs::create_directory(above, error);
    if (std::error_code loop; fs::is_directory(above, loop)) continue;
    if (fs::exists(fs::symlink_status(above))) set_aside(above);
    fs::create_directory(above);
  }
  const fs::path target = folder / path;
  const fs::file_status there = fs::symlink_status(target, error);
  if (!fs::exists(there)) return;
  if (for_folder ? fs::is_directory(there) : fs::is_regular_file(there)) return;
  set_aside(target);
}

void Store::State::set_aside(const fs::path& obstacle) {
  const fs::path aside = internal() / "set-aside" / (worker() + "-" + std::to_string(++attempts));
  fs::create_directories(aside);
  std::error_code error;  // another process may have been faster
  fs::rename(obstacle, aside / obstacle.filename(), error);
  if (error && fs::exists(fs::symlink_status(obstacle)))
    throw fs::filesystem_error("is in the way and cannot be moved", obstacle, error);
  note_repair(obstacle.lexically_relative(folder).generic_string() +
              ": something else lay in its place, and is now in " +
              aside.lexically_relative(folder).generic_string());
}

void Store::State::compare(const std::string& path, const Hash& before, const Maker& before_by,
                           const Hash& now) {
  if (before == now) return;
  const std::lock_guard guard(mutex);
  nondeterminism.push_back({path, before, now, before_by, self()});
}

void Store::State::note_repair(std::string text) {
  const std::lock_guard guard(mutex);
  repairs.insert(std::move(text));
}

}  // namespace mien::pipeline
