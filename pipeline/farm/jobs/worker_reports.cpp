#include "pipeline/farm/jobs/worker_reports.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <fstream>
#include <optional>
#include <system_error>
#include <tuple>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "pipeline/base/documents/files.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

// A worker writes every few seconds; a shared file system may show it late.
constexpr double alive_within_s = 90.0;

using FileTime = fs::file_time_type;

std::optional<FileTime> write_time_of(const fs::path& file) {
  std::error_code gone;
  const FileTime time = fs::last_write_time(file, gone);
  return gone ? std::nullopt : std::optional(time);
}

/// The time by the clock that stamps the files of a folder, which may be a file server's: that of a
/// file just written there, or this machine's where none can be written.
FileTime time_in(const fs::path& folder) {
  const fs::path probe = folder / fmt::format("status-{}.new", ::getpid());
  std::ofstream(probe) << '\n';
  const std::optional<FileTime> time = write_time_of(probe);
  std::error_code ignored;
  fs::remove(probe, ignored);
  return time.value_or(FileTime::clock::now());
}

}  // namespace

bool WorkerReport::is_alive() const { return !has_ended && report_age_s < alive_within_s; }

double WorkerReport::frames_per_second() const {
  return frame_seconds > 0.0 ? static_cast<double>(frames) / frame_seconds : 0.0;
}

std::vector<WorkerReport> worker_reports(const fs::path& folder) {
  const std::vector<WorkerRecord> records = read_worker_records(folder);
  if (records.empty()) return {};
  std::vector<std::optional<FileTime>> times;
  for (const WorkerRecord& record : records)
    times.push_back(write_time_of(worker_record_path(folder, record.name)));
  // No record is of the future.
  const FileTime now = std::max(time_in(folder / ".mien" / "workers"),
                                std::ranges::max(times).value_or(FileTime::min()));
  std::vector<WorkerReport> reports;
  for (std::size_t i = 0; i < records.size(); ++i) {
    const std::chrono::duration<double> age = now - times[i].value_or(now);
    reports.push_back({records[i], is_gone(records[i]), age.count()});
  }
  std::ranges::sort(reports, {},
                    [](const WorkerReport& report) { return std::tuple(report.host, report.pid); });
  return reports;
}

double measured_pace(const std::vector<WorkerReport>& reports) {
  double measured = 0.0;
  double estimated = 0.0;
  for (const WorkerReport& report : reports) {
    if (report.estimated_seconds <= 0.0) continue;
    measured += report.frame_seconds;
    estimated += report.estimated_seconds;
  }
  return measured > 0.0 ? measured / estimated : 1.0;
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
