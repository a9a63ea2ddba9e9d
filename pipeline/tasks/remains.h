#pragma once

#include <filesystem>
#include <string>

namespace mien::pipeline {

/// Records of processes that have ended are kept, those that drew frames: by the newest of them one
/// sees how long a frame takes.
inline constexpr std::size_t kept_records = 64;

/// Removes what processes left in a study's folder that will do nothing any more: attempts, claims,
/// records, but for the newest that tell how long frames took. `now` is a file that has just been
/// written there.
void remove_what_the_dead_left(const std::filesystem::path& folder,
                               const std::filesystem::path& now);

/// Removes what is of no use once all of a study is made: claims, and frames in the making, unless
/// a process other than `self` seems to work on some.
void remove_workings(const std::filesystem::path& folder, const std::filesystem::path& now,
                     const std::string& self);

}  // namespace mien::pipeline
