#pragma once

#include <atomic>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include <nlohmann/json.hpp>

#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// A still or video to render.
struct StudioJob {
  enum class Kind { still, video };

  Kind kind = Kind::still;
  Manifest manifest;               ///< with the stimulus and everything that it depends on
  std::string stimulus;            ///< id
  double seconds = 0.0;            ///< time of a still within the film, clamped to its duration
  std::optional<Quality> quality;  ///< empty: that of the manifest
};

/// Renders stills and videos in the background, one at a time. Thread-safe.
class StudioJobs {
 public:
  /// `folder` receives the results. It is separate from the output of `mien run`, since drafts are
  /// not part of a study. `threads`: number of rendering threads.
  StudioJobs(std::filesystem::path folder, int threads)
      : folder_(std::move(folder)), threads_(threads) {}

  /// Cancels the running job.
  ~StudioJobs() { cancel(); }
  StudioJobs(const StudioJobs&) = delete;
  StudioJobs& operator=(const StudioJobs&) = delete;

  /// Starts a job and returns its number; nullopt while another is running.
  std::optional<int> begin(StudioJob job);

  /// The status of a job as JSON: its number "job", its "kind" ("still" or "video"), the id of its
  /// "stimulus", its "state" ("running", "done", "failed" or "cancelled"), its progress "share" (0
  /// to 1), and "told": an error message or the path of the result; empty while there is neither.
  /// Null unless `job` is the last one.
  nlohmann::ordered_json status(int job) const;

  /// The status of the last job; null if there was none.
  nlohmann::ordered_json last() const;

  /// Requests the running job to stop.
  void cancel();

  /// The file with the result of a job, if it is the last one and done.
  std::optional<std::filesystem::path> result(int job) const;

 private:
  void work(const StudioJob& job, const std::stop_token& stop);
  std::filesystem::path make_still(const StudioJob& job, const std::stop_token& stop);
  std::filesystem::path make_video(const StudioJob& job, const std::stop_token& stop);
  void end(const std::string& state, const std::string& status);

  std::filesystem::path folder_;
  int threads_;
  mutable std::mutex mutex_;
  int number_ = 0;
  std::string kind_, stimulus_, state_ = "none", message_;
  std::filesystem::path result_;
  std::atomic<double> share_ = 0.0;
  std::jthread thread_;
};

}  // namespace mien::pipeline
