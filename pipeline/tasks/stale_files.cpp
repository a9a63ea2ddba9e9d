#include "pipeline/tasks/stale_files.h"

#include <algorithm>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include "pipeline/base/documents/files.h"
#include "pipeline/tasks/claim.h"
#include "pipeline/tasks/worker_record.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

/// Age at which a temporary file of a record counts as abandoned.
constexpr double abandoned_after_seconds = 3600.0;

class StaleFiles {
 public:
  StaleFiles(const fs::path& folder, const fs::path& now) : folder_(folder), now_(now) {}

  /// Attempts are in a folder named after the process, whose record existed before it.
  void remove_attempts() const {
    for (const fs::path& attempts : paths_in(folder_ / ".mien/attempts")) {
      if (is_stale(attempts.filename())) remove(attempts);
    }
  }

  /// A claim without a name is from a process that was killed at that moment or is about to write
  /// its name; in the latter case two processes may do the same work, which is harmless.
  void remove_claims() const {
    for (const fs::path& claim : paths_in(folder_ / ".mien/claims")) {
      const std::string holder = claim_holder(claim);
      if (holder.empty() || is_stale(holder)) remove(claim);
    }
  }

  void remove_records() const {
    for (const fs::path& file : paths_in(folder_ / ".mien/workers")) {
      if (file.extension() == ".new" && is_abandoned(file)) remove(file);
    }
    std::vector<std::pair<double, fs::path>>
        records;  // age in seconds, and record of a dead worker
    for (const WorkerRecord& record : read_worker_records(folder_)) {
      if (!is_dead(folder_, record, now_)) continue;
      const fs::path file = worker_record_path(folder_, record.name);
      if (record.frames > 0) {
        records.emplace_back(seconds_between(file, now_), file);
      } else if (!record.ended) {  // else it is removing its record itself
        remove(file);
      }
    }
    std::ranges::sort(records);
    for (std::size_t i = retained_records; i < records.size(); ++i) remove(records[i].second);
  }

 private:
  bool is_stale(const std::string& worker) const {
    const std::optional<WorkerRecord> record = read_worker_record(folder_, worker);
    return !record || is_dead(folder_, *record, now_);
  }

  /// Whether a temporary file is abandoned. Without a record, it may be that of a starting process.
  bool is_abandoned(const fs::path& unfinished) const {
    const auto record = read_worker_record(folder_, unfinished.stem().stem());
    if (record) return is_dead(folder_, *record, now_);
    return seconds_between(unfinished, now_) > abandoned_after_seconds;
  }

  static void remove(const fs::path& path) {
    std::error_code ignored;  // another process may be faster
    fs::remove_all(path, ignored);
  }

  const fs::path& folder_;
  const fs::path& now_;
};

/// Whether another live process has recorded unpublished frames.
bool other_workers_draw(const fs::path& folder, const fs::path& now, const std::string& self) {
  std::error_code error;
  for (fs::recursive_directory_iterator entry(folder / ".mien/partial", error);
       !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
    if (entry->path().parent_path().filename() != "notes") continue;
    const auto worker = read_worker_record(folder, entry->path().filename());
    if (worker && worker->name != self && works_now(folder, *worker, now)) return true;
  }
  return false;
}

}  // namespace

void remove_stale_files(const fs::path& folder, const fs::path& now) {
  const StaleFiles stale_files(folder, now);
  stale_files.remove_attempts();
  stale_files.remove_claims();
  stale_files.remove_records();
}

void remove_intermediates(const fs::path& folder, const fs::path& now, const std::string& self) {
  std::error_code ignored;
  fs::remove_all(folder / ".mien/claims", ignored);
  if (!other_workers_draw(folder, now, self)) fs::remove_all(folder / ".mien/partial", ignored);
}

}  // namespace mien::pipeline
