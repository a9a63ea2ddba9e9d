#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/tasks/worker_record.h"

namespace mien::pipeline {

/// What a process that works on a study says of itself every few seconds, and what that tells now.
struct WorkerReport : WorkerRecord {
  bool has_ended = false;
  double silent_s = 0.0;  ///< since it was last heard of

  /// Whether it works now: it has not ended and was heard of a short time ago.
  bool is_alive() const;
  double frames_per_second() const;
};

/// All of a study's folder that can be read, by host and process.
std::vector<WorkerReport> worker_reports(const std::filesystem::path& folder);

/// Seconds a frame took on average; 0 when none has been drawn.
double seconds_a_frame(const std::vector<WorkerReport>& reports);

/// An item that failed, and what is known of it (farm/failures/<item>.json).
struct FailedItem {
  std::string item;
  std::string error;
  int code = 0;
  std::string host;
  std::string when;
  int attempts = 0;
  std::string command;  ///< that reproduces it
};

/// By item.
std::vector<FailedItem> failed_items(const std::filesystem::path& folder);

}  // namespace mien::pipeline
