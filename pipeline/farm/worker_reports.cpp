#include "pipeline/farm/worker_reports.h"

#include <algorithm>
#include <chrono>
#include <tuple>

#include <nlohmann/json.hpp>

#include "pipeline/base/documents/files.h"
#include "pipeline/tasks/worker_record.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

// A worker writes every few seconds; a shared file system may show it late.
constexpr double silent_after_s = 90.0;

/// JSON files of a folder with their text parsed; what is damaged or half-written is left out.
template <class Read>
void read_each(const fs::path& folder, const Read& read) {
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    if (at->path().extension() != ".json") continue;
    try {
      read(json::parse(read_file(at->path())), at->path());
    } catch (const std::exception&) {
      continue;  // it will be whole the next time
    }
  }
}

double age_of(const fs::path& file) {
  std::error_code gone;
  const auto age = fs::file_time_type::clock::now() - fs::last_write_time(file, gone);
  if (gone) return 0.0;
  return std::max(0.0, std::chrono::duration<double>(age).count());
}

}  // namespace

bool WorkerReport::is_alive() const { return !has_ended && silent_s < silent_after_s; }

double WorkerReport::frames_per_second() const {
  return frame_seconds > 0.0 ? static_cast<double>(frames) / frame_seconds : 0.0;
}

std::vector<WorkerReport> worker_reports(const fs::path& folder) {
  std::vector<WorkerReport> reports;
  for (const WorkerRecord& record : read_worker_records(folder)) {
    WorkerReport report;
    report.host = record.host;
    report.process = static_cast<int>(record.process);
    report.job = record.job;
    report.has_ended = is_gone(record);
    report.silent_s = age_of(worker_record_path(folder, record.name));
    for (const auto& [task, share] : record.tasks) report.tasks.push_back(task);
    report.frames = record.frames;
    report.frame_seconds = record.frame_seconds;
    reports.push_back(std::move(report));
  }
  std::ranges::sort(reports, {}, [](const WorkerReport& report) {
    return std::tuple(report.host, report.process);
  });
  return reports;
}

double seconds_a_frame(const std::vector<WorkerReport>& reports) {
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
  read_each(folder / "farm" / "failures", [&](const json& told, const fs::path&) {
    failed.push_back({told.at("item"), told.value("error", ""), told.value("code", 0),
                      told.value("host", ""), told.value("when", ""), told.value("attempts", 0),
                      told.value("command", "")});
  });
  std::sort(failed.begin(), failed.end(),
            [](const auto& left, const auto& right) { return left.item < right.item; });
  return failed;
}

}  // namespace mien::pipeline
