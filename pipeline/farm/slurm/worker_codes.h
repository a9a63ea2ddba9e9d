#pragma once

namespace mien::pipeline {

// How `mien farm worker` ends (the numbers are those of sysexits.h), and what a job makes of it.
inline constexpr int worker_bad_input = 65;    ///< never tried again
inline constexpr int worker_no_disk = 74;      ///< full, read-only or away: waited for
inline constexpr int worker_transient = 75;    ///< stopped, or the machine's fault: tried again
inline constexpr int worker_wrong_setup = 78;  ///< held until somebody has looked at it
inline constexpr int worker_gave_up = 70;      ///< of a job: transient too often
inline constexpr int worker_killed = 137;      ///< SIGKILL: for want of memory, or by anybody

/// What a job notes behind its code where its control group counts a kill for want of memory.
inline constexpr const char* lack_of_memory = "memory";

/// How often a job goes back into the queue by itself.
inline constexpr int most_restarts = 3;

}  // namespace mien::pipeline
