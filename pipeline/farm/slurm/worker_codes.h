#pragma once

namespace mien::pipeline {

// Exit codes of `mien farm worker` (numbers of sysexits.h), and how a job reacts to them.
inline constexpr int worker_bad_input = 65;         ///< not repeated
inline constexpr int worker_disk_unavailable = 74;  ///< full, read-only or unavailable: waited for
inline constexpr int worker_transient = 75;    ///< stopped, or a fault of the machine: repeated
inline constexpr int worker_wrong_setup = 78;  ///< held until a user releases it
inline constexpr int worker_gave_up = 70;      ///< of a job: too many transient failures
inline constexpr int worker_killed = 137;      ///< SIGKILL: out of memory, or sent by a user

/// Recorded after the exit code if the job's control group counted an out-of-memory kill.
inline constexpr const char* out_of_memory_note = "memory";

/// Maximum number of times a job requeues itself.
inline constexpr int most_restarts = 3;

}  // namespace mien::pipeline
