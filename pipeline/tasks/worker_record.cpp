#include "pipeline/tasks/worker_record.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iterator>
#include <random>
#include <system_error>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sys/stat.h>
#include <unistd.h>

#include "motion/text/safe_name.h"
#include "pipeline/base/documents/files.h"
#include "render/tracer/tracer.h"

namespace mien::pipeline {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(WorkerRecord, name, host, boot, process_space, pid,
                                   process_start, job, instruction_set, started, beats, exclusive,
                                   ended, frames, frame_seconds)

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::string first_line_of(const fs::path& file) {
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  return line;
}

/// Slurm's node name inside a job, otherwise the machine's host name.
std::string host_name() {
  if (const char* node = std::getenv("SLURMD_NODENAME"); node != nullptr && *node != '\0')
    return node;
  std::array<char, 256> name{};
  if (::gethostname(name.data(), name.size() - 1) != 0 || name[0] == '\0') return "unknown";
  return name.data();
}

std::string process_space() {
  std::error_code error;
  return fs::read_symlink("/proc/self/ns/pid", error).string();
}

/// When a process began, in ticks after the boot: the 22nd word of its status, of which the second
/// is its program's name in brackets and may hold anything. Empty when there is no such process.
std::string start_of(std::int64_t process) {
  const std::string status = first_line_of(fmt::format("/proc/{}/stat", process));
  const std::size_t name_end = status.rfind(')');
  if (name_end == std::string::npos) return "";
  std::size_t at = name_end + 1;
  for (int word = 3; word < 22 && at != std::string::npos; ++word) at = status.find(' ', at + 1);
  if (at == std::string::npos) return "";
  return status.substr(at + 1, status.find(' ', at + 1) - at - 1);
}

/// A process on another machine without an update for so long is dead, or will notice that its
/// attempts were removed.
constexpr double remote_timeout_seconds = 24.0 * 3600.0;
constexpr double report_timeout_seconds = 60.0;

/// Whether the process can be checked from this machine.
bool is_of_this_machine(const WorkerRecord& record) {
  static const std::string boot = first_line_of("/proc/sys/kernel/random/boot_id");
  return !boot.empty() && record.boot == boot && record.process_space == process_space();
}

/// A process that has ended but was not waited for does nothing more.
bool is_zombie(std::int64_t process) {
  const std::string status = first_line_of(fmt::format("/proc/{}/stat", process));
  const std::size_t name_end = status.rfind(')');
  return name_end != std::string::npos && status.compare(name_end, 3, ") Z") == 0;
}

std::string random_word() {
  std::random_device random;
  return fmt::format("{:08x}{:08x}", random(), random());
}

/// What follows the last comma: "Embree 4.3.3, avx2".
std::string instruction_set() {
  const std::string description = render::Tracer().description();
  const std::size_t comma = description.rfind(", ");
  return comma == std::string::npos ? description : description.substr(comma + 2);
}

/// A file's last change, in seconds.
std::optional<double> time_of(const fs::path& file) {
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0) return std::nullopt;
  return static_cast<double>(status.st_mtim.tv_sec) +
         1e-9 * static_cast<double>(status.st_mtim.tv_nsec);
}

}  // namespace

WorkerRecord record_of_this_process() {
  static const std::string instructions = instruction_set();
  WorkerRecord record;
  record.host = host_name();
  record.boot = first_line_of("/proc/sys/kernel/random/boot_id");
  record.process_space = process_space();
  record.pid = ::getpid();
  record.process_start = start_of(record.pid);
  if (const char* job = std::getenv("SLURM_JOB_ID"); job != nullptr) record.job = job;
  record.instruction_set = instructions;
  record.started = fmt::format("{:%FT%TZ}", fmt::gmtime(std::time(nullptr)));
  record.name = fmt::format("{}-{}-{}", record.host, record.pid, random_word());
  return record;
}

std::string to_json(const WorkerRecord& record) {
  json object = record;
  object["estimated_seconds"] = record.estimated_seconds;
  object["tasks"] = json::array();
  for (const auto& [id, share] : record.tasks)
    object["tasks"].push_back({{"id", id}, {"share", share}});
  return object.dump(1) + "\n";
}

std::optional<WorkerRecord> worker_record_from_json(const std::string& text) {
  try {
    const json object = json::parse(text);
    auto record = object.get<WorkerRecord>();
    record.estimated_seconds = object.value("estimated_seconds", 0.0);
    for (const json& task : object.at("tasks")) record.tasks[task.at("id")] = task.at("share");
    return record;
  } catch (const json::exception&) {
    return std::nullopt;
  }
}

fs::path worker_record_path(const fs::path& folder, const std::string& name) {
  return folder / ".mien" / "workers" / (name + ".json");
}

std::optional<WorkerRecord> read_worker_record(const fs::path& folder, const std::string& name) {
  // What a claim or a note calls its process may be anything.
  if (!motion::fault_of_name(name).empty()) return std::nullopt;
  const fs::path file = worker_record_path(folder, name);
  std::error_code none;
  if (!fs::is_regular_file(file, none)) return std::nullopt;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return std::nullopt;
  auto record = worker_record_from_json({std::istreambuf_iterator<char>(stream), {}});
  // A record whose name does not match its file was not written by mien.
  return record && record->name == name ? std::move(record) : std::nullopt;
}

std::vector<WorkerRecord> read_worker_records(const fs::path& folder) {
  std::vector<WorkerRecord> records;
  std::error_code error;
  for (const fs::directory_entry& entry :
       fs::directory_iterator(folder / ".mien" / "workers", error)) {
    if (entry.path().extension() != ".json") continue;
    if (auto record = read_worker_record(folder, entry.path().stem().string()))
      records.push_back(std::move(*record));
  }
  std::ranges::sort(records, {}, &WorkerRecord::name);
  return records;
}

bool is_gone(const WorkerRecord& record) {
  if (record.ended) return true;
  if (!is_of_this_machine(record)) return false;
  const std::string start = start_of(record.pid);
  // Processes of other users may be hidden in /proc, but kill still reports whether they exist.
  if (start.empty()) return ::kill(static_cast<pid_t>(record.pid), 0) != 0 && errno == ESRCH;
  return start != record.process_start || is_zombie(record.pid);
}

bool works_now(const fs::path& folder, const WorkerRecord& record, const fs::path& now) {
  return !is_gone(record) && seconds_since_record(folder, record, now) < report_timeout_seconds;
}

bool is_dead(const fs::path& folder, const WorkerRecord& record, const fs::path& now) {
  if (is_gone(record)) return true;
  return !is_of_this_machine(record) &&
         seconds_since_record(folder, record, now) > remote_timeout_seconds;
}

double seconds_between(const fs::path& one, const fs::path& other) {
  const auto begin = time_of(one);
  const auto end = time_of(other);
  return begin && end ? *end - *begin : 0.0;
}

double seconds_since_record(const fs::path& folder, const WorkerRecord& record,
                            const fs::path& now) {
  return seconds_between(worker_record_path(folder, record.name), now);
}

}  // namespace mien::pipeline
