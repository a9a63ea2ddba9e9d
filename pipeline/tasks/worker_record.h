#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace mien::pipeline {

/// Record of a process that works on a study, from which other processes, also on other machines,
/// can determine whether it is alive. Stored in <study>/.mien/workers/<name>.json.
struct WorkerRecord {
  std::string name;           ///< "host-4711-9f3a01c25b7e40d8", unique
  std::string host;           ///< machine name, or Slurm's node name
  std::string boot;           ///< boot id of the machine, new after each boot
  std::string process_space;  ///< PID namespace (containers have their own)
  std::int64_t pid = 0;
  std::string process_start;  ///< ticks after the boot, since PIDs are reused
  std::string job;            ///< ID of the Slurm job it runs in: "17"; empty if none
  /// Instruction set of the processor, as used by the renderer: "avx2".
  std::string instruction_set;
  std::string started;      ///< UTC, for display
  std::uint64_t beats = 0;  ///< increases as long as the process runs
  bool exclusive = false;   ///< requires exclusive access to the folder
  bool ended = false;
  std::map<std::string, double> tasks;  ///< running tasks → share done, 0 … 1
  std::int64_t frames = 0;              ///< number drawn so far
  double frame_seconds = 0.0;           ///< total time spent drawing them
  double estimated_seconds = 0.0;       ///< total estimate for them; 0 in records of older versions
};

/// A new record of this process, with a unique name.
WorkerRecord record_of_this_process();

std::string to_json(const WorkerRecord& record);

/// Parses a record; nothing if the text is not one.
std::optional<WorkerRecord> worker_record_from_json(const std::string& text);

/// <folder>/.mien/workers/<name>.json
std::filesystem::path worker_record_path(const std::filesystem::path& folder,
                                         const std::string& name);

/// Reads a worker's record; nothing if it is missing or unreadable.
std::optional<WorkerRecord> read_worker_record(const std::filesystem::path& folder,
                                               const std::string& name);

/// All readable records in a study's folder, sorted by name.
std::vector<WorkerRecord> read_worker_records(const std::filesystem::path& folder);

/// Whether the process is proven to have ended: its record states this, or the process was started
/// on this machine, after the machine's last boot and in this PID namespace, and no longer exists.
/// For a process of another machine, boot or namespace, true only if its record states this.
bool is_gone(const WorkerRecord& record);

/// Whether a process is working now: it is not proven to have ended, and its record was updated
/// less than a minute ago. `folder`, `now`: see seconds_since_record.
bool works_now(const std::filesystem::path& folder, const WorkerRecord& record,
               const std::filesystem::path& now);

/// Whether a process is (almost) certainly dead: it is proven to have ended, or it is of another
/// machine, boot or PID namespace than this process and has not updated its record for a day.
/// `folder`, `now`: see seconds_since_record.
bool is_dead(const std::filesystem::path& folder, const WorkerRecord& record,
             const std::filesystem::path& now);

/// Seconds from the last change of `one` to that of `other`, by the file system's clock; 0 if
/// either does not exist.
double seconds_between(const std::filesystem::path& one, const std::filesystem::path& other);

/// Age of a worker's record, seconds, by the file system's clock. `folder`: the study's. `now`: a
/// file just written in it; its modification time is taken as the current time. Negative if the
/// clock was set back; 0 if there is no record.
double seconds_since_record(const std::filesystem::path& folder, const WorkerRecord& record,
                            const std::filesystem::path& now);

}  // namespace mien::pipeline
