#include "pipeline/farm/jobs/worker_reports.h"

#include <algorithm>
#include <chrono>
#include <tuple>

#include <nlohmann/json.hpp>

#include "pipeline/base/documents/files.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

// A worker writes every few seconds; a shared file system may show it late.
constexpr double alive_within_s = 90.0;

double age_of(const fs::path& file) {
  std::error_code gone;
  const auto age = fs::file_time_type::clock::now() - fs::last_write_time(file, gone);
  if (gone) return 0.0;
  return std::max(0.0, std::chrono::duration<double>(age).count());
}

}  // namespace

bool WorkerReport::is_alive() const { return !has_ended && report_age_s < alive_within_s; }

double WorkerReport::frames_per_second() const {
  return frame_seconds > 0.0 ? static_cast<double>(frames) / frame_seconds : 0.0;
}

std::vector<WorkerReport> worker_reports(const fs::path& folder) {
  std::vector<WorkerReport> reports;
  for (const WorkerRecord& record : read_worker_records(folder)) {
    const double report_age_s = age_of(worker_record_path(folder, record.name));
    reports.push_back({record, is_gone(record), report_age_s});
  }
  std::ranges::sort(reports, {},
                    [](const WorkerReport& report) { return std::tuple(report.host, report.pid); });
  return reports;
}

double seconds_per_frame(const std::vector<WorkerReport>& reports) {
  long long frames = 0;
  double seconds = 0.0;
  for (const WorkerReport& report : reports) {
    frames += report.frames;
    seconds += report.frame_seconds;
  }
  return frames > 0 ? seconds / static_cast<double>(frames) : 0.0;
}

std::vector<FailedItem> failed_items(const fs::path& folder) {
  std::vector<FailedItem> failed;
  for (const fs::path& file : paths_in(folder / "farm" / "failures")) {
    if (file.extension() != ".json") continue;
    try {
      const json failure = json::parse(read_file(file));
      failed.push_back({failure.at("item"), failure.value("error", ""), failure.value("code", 0),
                        failure.value("host", ""), failure.value("when", ""),
                        failure.value("attempts", 0), failure.value("command", "")});
    } catch (const std::exception&) {
      continue;  // half-written: it will be whole the next time
    }
  }
  std::ranges::sort(failed, {}, &FailedItem::item);
  return failed;
}

}  // namespace mien::pipeline
