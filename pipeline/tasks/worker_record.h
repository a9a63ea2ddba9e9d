#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace mien::pipeline {

/// A process that works on a study, told so that another one, perhaps on another machine, can see
/// whether it still lives. Lies in <study>/.mien/workers/<name>.json.
struct WorkerRecord {
  std::string name;             ///< "host-4711-9f3a01c2", of no other process ever
  std::string host;             ///< the machine, or the node as Slurm calls it
  std::string boot;             ///< of the machine: another one after each start
  std::string process_space;    ///< in which the number counts (containers have their own)
  std::int64_t pid = 0;         ///< its number
  std::string process_start;    ///< ticks after the boot, since numbers are used again
  std::string job;              ///< Slurm's, in which it runs: "17"; empty where there is none
  std::string instruction_set;  ///< of the processor, as far as pictures are concerned: "avx2"
  std::string started;          ///< UTC, for people
  std::uint64_t beats = 0;      ///< counts up while it lives
  bool exclusive = false;       ///< wants nobody else in the folder
  bool ended = false;
  std::map<std::string, double> tasks;  ///< at the moment → share done, 0 … 1
  std::int64_t frames = 0;              ///< drawn so far
  double frame_seconds = 0.0;           ///< that their drawing took
};

/// Of this process, with a name of its own.
WorkerRecord record_of_this_process();

std::string to_json(const WorkerRecord& record);

/// Nothing when the text is no record.
std::optional<WorkerRecord> worker_record_from_json(const std::string& text);

/// <folder>/.mien/workers/<name>.json
std::filesystem::path worker_record_path(const std::filesystem::path& folder,
                                         const std::string& name);

/// Nothing when there is none, or none that can be read.
std::optional<WorkerRecord> read_worker_record(const std::filesystem::path& folder,
                                               const std::string& name);

/// All records in a study's folder, by name.
std::vector<WorkerRecord> read_worker_records(const std::filesystem::path& folder);

/// Whether it is proven that the process does no more: it said so, or it was one of this machine
/// and is not there. Of another machine's processes nothing is proven.
bool is_gone(const WorkerRecord& record);

/// Whether a process works now, judged at once. `now` as below.
bool works_now(const std::filesystem::path& folder, const WorkerRecord& record,
               const std::filesystem::path& now);

/// Whether it is certain, or as good as certain, that a process will do nothing any more: it is
/// gone, or of another machine and silent for a day.
bool is_dead(const std::filesystem::path& folder, const WorkerRecord& record,
             const std::filesystem::path& now);

/// Seconds from one file's last change to another's, by the clock of the file system that holds
/// them; 0 when one of them is not there.
double seconds_between(const std::filesystem::path& one, const std::filesystem::path& other);

/// Seconds since a worker last wrote its record, by the clock of the file system that holds it.
/// `now` is a file that has just been written there. Negative when the clock was set back.
double seconds_silent(const std::filesystem::path& folder, const WorkerRecord& record,
                      const std::filesystem::path& now);

}  // namespace mien::pipeline
