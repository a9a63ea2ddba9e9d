#pragma once

#include <filesystem>
#include <string>

namespace mien::pipeline {

/// Maximum number of kept records of ended processes. The newest records of processes that drew
/// frames are kept, because the time per frame is estimated from them.
inline constexpr std::size_t retained_records = 64;

/// Removes attempts, claims and records of dead processes from a study's folder, except the newest
/// `retained_records` records of processes that drew frames. A process without a record counts as
/// dead; claims that name no process are removed, too. `now` is a file just written in the folder;
/// its modification time is taken as the current time.
void remove_stale_files(const std::filesystem::path& folder, const std::filesystem::path& now);

/// Removes files that are not needed once a study is complete: all claims, and all unpublished
/// frames unless a process other than `self` has drawn some of them and is working now. `now`: as
/// above.
void remove_intermediates(const std::filesystem::path& folder, const std::filesystem::path& now,
                          const std::string& self);

}  // namespace mien::pipeline
