#include "pipeline/tasks/worker_heartbeat.h"

#include <chrono>
#include <exception>
#include <system_error>
#include <utility>

#include "pipeline/base/documents/files.h"
#include "pipeline/tasks/progress.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

constexpr std::chrono::seconds heartbeat_interval{3};

WorkerRecord new_record(bool exclusive) {
  WorkerRecord record = record_of_this_process();
  record.exclusive = exclusive;
  return record;
}

}  // namespace

WorkerHeartbeat::WorkerHeartbeat(fs::path folder, bool exclusive)
    : folder_(std::move(folder)), self_(new_record(exclusive)), now_(self_) {
  make_folder(file().parent_path());
  write(self_);
  thread_ = std::thread([this] { run_until_closed(); });
}

WorkerHeartbeat::~WorkerHeartbeat() {
  {
    const std::lock_guard guard(mutex_);
    closing_ = true;
    now_.ended = true;
    now_.tasks.clear();
  }
  closed_.notify_all();
  thread_.join();
  std::error_code ignored;
  if (now_.frames == 0) {
    fs::remove(file(), ignored);
    return;
  }
  try {
    write(now_);
  } catch (const std::exception&) {  // the folder has gone; so has what the record is good for
    fs::remove(file(), ignored);
  }
}

fs::path WorkerHeartbeat::file() const { return worker_record_path(folder_, self_.name); }

void WorkerHeartbeat::report_progress(const std::string& task, double share) {
  const std::lock_guard guard(mutex_);
  now_.tasks[task] = share;
}

void WorkerHeartbeat::end_task(const std::string& task) {
  const std::lock_guard guard(mutex_);
  now_.tasks.erase(task);
}

void WorkerHeartbeat::count_frame(double seconds, double estimated_seconds) {
  const std::lock_guard guard(mutex_);
  ++now_.frames;
  now_.frame_seconds += seconds;
  now_.estimated_seconds += estimated_seconds;
}

void WorkerHeartbeat::write_now() {
  WorkerRecord record;
  {
    const std::lock_guard guard(mutex_);
    ++now_.beats;
    record = now_;
  }
  write(std::move(record));
}

/// A failed write, on a disk that is full for a while, is made up for by the next one.
void WorkerHeartbeat::run_until_closed() {
  std::unique_lock lock(mutex_);
  while (!closed_.wait_for(lock, heartbeat_interval, [this] { return closing_; })) {
    lock.unlock();
    try {
      write_now();
    } catch (const std::exception&) {  // NOLINT(bugprone-empty-catch)
    }
    lock.lock();
  }
}

void WorkerHeartbeat::write(WorkerRecord record) {
  const std::lock_guard guard(writing_);
  const fs::path target = file();
  fs::path next = target;
  next += ".new";
  replace_file(target, next, to_json(record));
}

bool WorkerWatch::seems_alive(const std::string& worker) {
  const std::optional<WorkerRecord> record = read_worker_record(folder_, worker);
  if (!record || is_gone(*record)) return false;
  const double now = steady_seconds();
  const std::lock_guard guard(mutex_);
  const auto [seen, is_new] =
      last_heartbeats_.try_emplace(worker, LastHeartbeat{record->beats, now});
  if (!is_new && seen->second.beats != record->beats) seen->second = {record->beats, now};
  return now - seen->second.at < heartbeat_timeout_seconds;
}

}  // namespace mien::pipeline
