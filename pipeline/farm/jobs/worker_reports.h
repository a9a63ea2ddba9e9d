#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/tasks/worker_record.h"

namespace mien::pipeline {

/// The record that a worker process writes every few seconds, and its age.
struct WorkerReport : WorkerRecord {
  bool has_ended = false;
  double report_age_s = 0.0;  ///< seconds since its last record

  /// Whether it is working now: it has not ended and its last record is recent.
  bool is_alive() const;
  double frames_per_second() const;
};

/// All readable reports in a study's folder, sorted by host and process.
std::vector<WorkerReport> worker_reports(const std::filesystem::path& folder);

/// Mean time per frame, seconds; 0 if none has been drawn.
double seconds_per_frame(const std::vector<WorkerReport>& reports);

/// A failed item as recorded in farm/failures/<item>.json.
struct FailedItem {
  std::string item;
  std::string error;
  int code = 0;
  std::string host;
  std::string when;
  int attempts = 0;
  std::string command;  ///< that reproduces it
};

/// All failed items of a study's folder, sorted by item.
std::vector<FailedItem> failed_items(const std::filesystem::path& folder);

}  // namespace mien::pipeline
