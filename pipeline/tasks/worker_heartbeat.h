#pragma once

#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <string>
#include <thread>

#include "pipeline/tasks/worker_record.h"

namespace mien::pipeline {

/// Shows other processes that this one works on a study: writes its record at the start and every
/// few seconds. At the end, the record is marked as ended if this process drew frames, and removed
/// otherwise. Thread-safe.
class WorkerHeartbeat {
 public:
  /// Throws std::runtime_error if the folder is not writable.
  WorkerHeartbeat(std::filesystem::path folder, bool exclusive);
  ~WorkerHeartbeat();
  WorkerHeartbeat(const WorkerHeartbeat&) = delete;
  WorkerHeartbeat& operator=(const WorkerHeartbeat&) = delete;

  const WorkerRecord& self() const {
    return self_;
  }  ///< identity of this process, which is constant
  std::filesystem::path file() const;

  void report_progress(const std::string& task, double share);
  void end_task(const std::string& task);

  /// Counts a frame that was drawn. `seconds`: the time that it took; `estimated_seconds`: its
  /// share of the task's estimate (Task::cost_seconds).
  void count_frame(double seconds, double estimated_seconds);

  /// Writes the record now.
  void write_now();

 private:
  void run_until_closed();
  void write(WorkerRecord record);

  std::filesystem::path folder_;
  const WorkerRecord self_;
  std::mutex writing_;  ///< guards the file
  std::mutex mutex_;    ///< guards now_ and closing_
  WorkerRecord now_;
  bool closing_ = false;
  std::condition_variable closed_;
  std::thread thread_;
};

/// Determines which workers are alive, as observed by this process.
class WorkerWatch {
 public:
  explicit WorkerWatch(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// False if the process is proven to have ended, has no record any more, or has not updated it
  /// for `heartbeat_timeout_seconds` between calls of this function. Independent of the clocks of
  /// other machines and file systems. A suspended process counts as dead after that time and may
  /// resume later.
  bool seems_alive(const std::string& worker);

  static constexpr double heartbeat_timeout_seconds = 30.0;

 private:
  struct LastHeartbeat {
    std::uint64_t beats = 0;
    double at = 0.0;  ///< time of the monotonic clock, seconds
  };

  std::filesystem::path folder_;
  std::mutex mutex_;
  std::map<std::string, LastHeartbeat> last_heartbeats_;
};

}  // namespace mien::pipeline
