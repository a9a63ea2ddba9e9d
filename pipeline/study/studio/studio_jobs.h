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

/// A picture or film by the real renderer.
struct StudioJob {
  enum class Kind { still, video };

  Kind kind = Kind::still;
  Manifest manifest;               ///< of the stimulus and what it is made from
  std::string stimulus;            ///< id
  double seconds = 0.0;            ///< of a still: when in the film; cut to its length
  std::optional<Quality> quality;  ///< instead of the manifest's
};

/// Makes pictures and films in the background, one at a time. For several threads.
class StudioJobs {
 public:
  /// `folder` is where they are put, beside what `mien run` makes: drafts are no part of a study.
  StudioJobs(std::filesystem::path folder, int threads)
      : folder_(std::move(folder)), threads_(threads) {}

  /// Ends what is under way.
  ~StudioJobs() { cancel(); }
  StudioJobs(const StudioJobs&) = delete;
  StudioJobs& operator=(const StudioJobs&) = delete;

  /// Its number; nothing while another is under way.
  std::optional<int> begin(StudioJob job);

  /// {"job": 3, "kind": "still", "stimulus": …, "state": "running", "done", "failed" or
  /// "cancelled", "share": 0 … 1, "told": what went wrong, or where it lies}; null for one that is
  /// not the last.
  nlohmann::ordered_json told(int job) const;

  /// The same about the last one; null before the first.
  nlohmann::ordered_json last() const;

  /// Stops what is under way, soon.
  void cancel();

  /// What was made by the last job, when it is done.
  std::optional<std::filesystem::path> result(int job) const;

 private:
  void work(const StudioJob& job, const std::stop_token& stop);
  std::filesystem::path make_still(const StudioJob& job, const std::stop_token& stop);
  std::filesystem::path make_video(const StudioJob& job, const std::stop_token& stop);
  void end(const std::string& state, const std::string& told);

  std::filesystem::path folder_;
  int threads_;
  mutable std::mutex mutex_;
  int number_ = 0;
  std::string kind_, stimulus_, state_ = "none", told_;
  std::filesystem::path result_;
  std::atomic<double> share_ = 0.0;
  std::jthread thread_;
};

}  // namespace mien::pipeline
