#include "pipeline/tasks/store_state.h"

#include <cstdio>
#include <optional>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>

#include "pipeline/base/documents/files.h"
#include "pipeline/tasks/disk_fault.h"
#include "pipeline/tasks/stale_files.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

constexpr int tries_to_publish = 100;  ///< against others that publish in the same place

/// An attempt's folder, which the destructor removes.
class Attempt {
 public:
  explicit Attempt(fs::path folder) : folder_(std::move(folder)) {
    fs::create_directories(folder_);
  }
  ~Attempt() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  Attempt(const Attempt&) = delete;
  Attempt& operator=(const Attempt&) = delete;

  const fs::path& folder() const { return folder_; }

 private:
  fs::path folder_;
};

/// Exchanges two folders atomically. Returns false if one does not exist or the file system does
/// not support it.
bool exchange([[maybe_unused]] const fs::path& one, [[maybe_unused]] const fs::path& other) {
#ifdef RENAME_EXCHANGE
  return ::renameat2(AT_FDCWD, one.c_str(), AT_FDCWD, other.c_str(), RENAME_EXCHANGE) == 0;
#else
  return false;
#endif
}

/// The disk that holds a folder; nothing when there is no such folder.
std::optional<std::uint64_t> disk_of(const fs::path& folder) {
  struct stat status {};
  if (::stat(folder.c_str(), &status) != 0) return std::nullopt;
  return status.st_dev;
}

/// What is in the place of a folder that is to be published, without the files of the folder that
/// was published there before and of the next one.
std::vector<fs::path> foreign_entries(const fs::path& folder, const Receipt& next) {
  std::set<std::string> own;
  for (const FrameReceipt& frame : next.frames) own.insert(frame.name);
  if (const std::optional<Receipt> before = read_receipt(folder, next.path))
    for (const FrameReceipt& frame : before->frames) own.insert(frame.name);
  std::vector<fs::path> foreign;
  std::error_code none;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder / next.path, none)) {
    const bool is_own = own.contains(entry.path().filename().string());
    if (!is_own || entry.is_directory(none)) foreign.push_back(entry.path());
  }
  return foreign;
}

}  // namespace

Store::State::State(fs::path at, Sharing sharing)
    : folder(std::move(at)),
      heartbeat(folder, sharing == Sharing::exclusive),
      disk(disk_of(folder).value_or(0)),
      watch(folder) {
  refuse_other_workers(sharing);
  remove_stale_files(folder, heartbeat.file());
}

/// Also removes the files of processes killed in the meantime.
Store::State::~State() {
  std::error_code ignored;
  fs::remove_all(internal() / "attempts" / worker(), ignored);
  remove_stale_files(folder, heartbeat.file());
}

/// Each process writes its record before reading the others, so that of two processes starting at
/// the same time at least one sees the other.
void Store::State::refuse_other_workers(Sharing sharing) {
  for (const WorkerRecord& other : read_worker_records(folder)) {
    if (other.name == worker() || !works_now(folder, other, heartbeat.file())) continue;
    if (sharing == Sharing::shared && !other.exclusive) continue;
    throw StoreBusy("another process works in " + folder.string() + " (number " +
                    std::to_string(other.pid) + " on " + other.host +
                    "); wait for it to end, or choose another folder with --out");
  }
}

fs::path Store::State::new_attempt() {
  return internal() / "attempts" / worker() / std::to_string(++attempts);
}

/// An unmounted disk leaves its empty mount point behind; files written there would be lost.
void Store::State::refuse_missing_folder() const {
  const auto now = disk_of(folder);
  if (now && *now == disk) return;
  throw DiskFault(folder.string() +
                  (now ? " is on another disk than before" : " no longer exists") +
                  "; restore the disk that held it, and run the same command again to continue");
}

void Store::State::in_attempt(const std::function<void(const fs::path&)>& work) {
  refuse_missing_folder();
  const Attempt attempt(new_attempt());
  try {
    work(attempt.folder());
  } catch (const std::exception& error) {
    if (const std::string fault = disk_fault(folder, error); !fault.empty()) throw DiskFault(fault);
    std::error_code unknown;
    if (fs::exists(attempt.folder(), unknown) || unknown) throw;
    throw WriteFailure(std::string(error.what()) + " (the folder was removed)");
  }
}

Receipt Store::State::publish(const fs::path& attempt, Receipt receipt) {
  if (auto before = find_artifact(folder, receipt.path, receipt.key)) {
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

void Store::State::move_into_place(const fs::path& attempt, const Receipt& receipt) {
  const fs::path target = folder / receipt.path;
  const bool is_folder = !receipt.frames.empty();
  for (int tries = 1;; ++tries) {
    clear_path_for(receipt.path, is_folder);
    if (is_folder) set_aside_foreign(receipt);
    if (is_folder && exchange(attempt, target)) break;
    if (is_folder && fs::exists(target)) {  // no folder takes the place of one that is not empty
      const Attempt away(new_attempt());
      std::error_code gone;  // another process may have been faster
      fs::rename(target, away.folder() / "replaced", gone);
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
  const Attempt attempt(new_attempt());
  const fs::path written = attempt.folder() / "receipt";
  write_file(written, to_json(receipt));
  flush_to_disk(written);
  const fs::path target = receipt_path(folder, receipt.path);
  clear_path_for(target.lexically_relative(folder).generic_string(), false);
  fs::rename(written, target);
  flush_to_disk(target.parent_path());
}

void Store::State::clear_path_for(const std::string& path, bool for_folder) {
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

/// A new folder for what is not mien's.
fs::path Store::State::new_aside() {
  fs::path aside = internal() / "set-aside" / (worker() + "-" + std::to_string(++attempts));
  fs::create_directories(aside);
  return aside;
}

void Store::State::set_aside(const fs::path& obstacle) {
  const fs::path aside = new_aside();
  std::error_code error;  // another process may have been faster
  fs::rename(obstacle, aside / obstacle.filename(), error);
  if (error && fs::exists(fs::symlink_status(obstacle)))
    throw fs::filesystem_error("is in the way and cannot be moved", obstacle, error);
  note_repair(obstacle.lexically_relative(folder).generic_string() +
              ": another file was in its place, and has been moved to " +
              aside.lexically_relative(folder).generic_string());
}

/// Empties the folder that is about to be replaced of what is neither of the artifact that it holds
/// nor of the next one: it is the user's own.
void Store::State::set_aside_foreign(const Receipt& next) {
  const std::vector<fs::path> foreign = foreign_entries(folder, next);
  if (foreign.empty()) return;
  const fs::path aside = new_aside();
  std::string moved;
  for (const fs::path& entry : foreign) {
    const std::string name = entry.filename().string();
    std::error_code error;  // another process may have been faster
    fs::rename(entry, aside / name, error);
    if (!error) moved += (moved.empty() ? "" : ", ") + name;
    const bool is_hidden = name.starts_with('.');  // a network file system may hold on to it
    if (error && !is_hidden && fs::exists(fs::symlink_status(entry)))
      throw fs::filesystem_error("was not made by mien and cannot be moved", entry, error);
  }
  if (!moved.empty())
    note_repair(next.path + ": files that mien did not make were in this folder, and have been " +
                "moved to " + aside.lexically_relative(folder).generic_string() + ": " + moved);
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
