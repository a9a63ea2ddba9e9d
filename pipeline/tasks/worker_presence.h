#pragma once

#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <string>
#include <thread>

#include "pipeline/tasks/worker_record.h"

namespace mien::pipeline {

/// Shows others that this process works on a study: writes its record when it begins, every few
/// seconds, and when it ends. Its record stays only if frames were drawn. May be used by several
/// threads.
class WorkerPresence {
 public:
  /// Throws std::runtime_error when the folder cannot be written to.
  WorkerPresence(std::filesystem::path folder, bool exclusive);
  ~WorkerPresence();
  WorkerPresence(const WorkerPresence&) = delete;
  WorkerPresence& operator=(const WorkerPresence&) = delete;

  const WorkerRecord& self() const { return self_; }  ///< whose identity never changes
  std::filesystem::path file() const;

  void works_on(const std::string& task, double share);
  void leaves(const std::string& task);
  void drew_frame(double seconds);

  /// Writes the record now.
  void beat();

 private:
  void beat_until_closed();
  void write(WorkerRecord record);

  std::filesystem::path folder_;
  const WorkerRecord self_;
  std::mutex writing_;  ///< of the file
  std::mutex mutex_;    ///< of now_ and closing_
  WorkerRecord now_;
  bool closing_ = false;
  std::condition_variable closed_;
  std::thread thread_;
};

/// Tells workers that live from those that do not, as far as one can tell from here.
class WorkerWatch {
 public:
  explicit WorkerWatch(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// False when it is proven gone, has no record any more, or has shown no sign of life for
  /// `patience_seconds` while this object was asked about it. Clocks of machines and of file
  /// systems have no part in it. A process that is stopped counts as dead then and may come back.
  bool seems_alive(const std::string& worker);

  static constexpr double patience_seconds = 30.0;

 private:
  struct Seen {
    std::uint64_t beats = 0;
    double at = 0.0;  ///< seconds of a clock that is never set back
  };

  std::filesystem::path folder_;
  std::mutex mutex_;
  std::map<std::string, Seen> seen_;
};

}  // namespace mien::pipeline
