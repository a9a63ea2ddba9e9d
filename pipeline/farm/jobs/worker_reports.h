#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/tasks/worker_record.h"

namespace mien::pipeline {

/// The record that a worker process writes every few seconds, and its age.
struct WorkerReport : WorkerRecord {
  bool has_ended = false;  ///< proven: recorded, or the process no longer exists (is_gone)
  /// Seconds since its last record, by the clock of the folder's file system.
  double report_age_s = 0.0;

  /// Whether the worker is active: it has not ended and its last record is recent.
  bool is_alive() const;
  double frames_per_second() const;
};

/// All readable reports in a study's folder, sorted by host and process. Writes and removes a file
/// beside them, to learn the time of the file system, if that is possible.
std::vector<WorkerReport> worker_reports(const std::filesystem::path& folder);

/// Measured seconds of drawing per estimated second, over all frames of which the estimate is
/// known, whatever their quality and size were; 1 if there are none.
double measured_pace(const std::vector<WorkerReport>& reports);

/// A failed item as recorded in a file in farm/failures/.
struct FailedItem {
  std::string item;
  std::string error;
  int code = 0;  ///< exit code (worker_codes.h)
  std::string host;
  std::string when;
  int attempts = 0;     ///< number of failed attempts
  std::string command;  ///< command that reproduces the failure
};

/// All failed items recorded in a study's folder, sorted by item.
std::vector<FailedItem> failed_items(const std::filesystem::path& folder);

}  // namespace mien::pipeline
