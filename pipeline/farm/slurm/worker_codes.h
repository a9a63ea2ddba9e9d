#pragma once

namespace mien::pipeline {

// Exit codes of `mien farm worker` (most numbers as in sysexits.h), and the reaction of its job.
inline constexpr int worker_bad_input = 65;  ///< the job is not repeated
inline constexpr int worker_disk_unavailable =
    74;  ///< the disk is full, read-only or unavailable: the job waits
inline constexpr int worker_transient = 75;    ///< stopped, or a fault of the machine: requeued
inline constexpr int worker_wrong_setup = 78;  ///< the job is held until a user releases it
inline constexpr int worker_gave_up = 70;  ///< any other failure, or nondeterminism; also the code
                                           ///< of a job after too many transient failures
inline constexpr int worker_killed = 137;  ///< SIGKILL: out of memory, or sent by a user

/// Recorded after the exit code if the job's control group counted an out-of-memory kill.
inline constexpr const char* out_of_memory_note = "memory";

/// Maximum number of times a job requeues itself.
inline constexpr int most_restarts = 3;

}  // namespace mien::pipeline
