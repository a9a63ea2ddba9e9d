#pragma once

#include <filesystem>
#include <string>

namespace mien::pipeline {

/// Removes what processes left in a study's folder that will do nothing any more: attempts, claims,
/// records that tell of no frames. `now` is a file that has just been written there.
void remove_what_the_dead_left(const std::filesystem::path& folder,
                               const std::filesystem::path& now);

/// Removes what is of no use once all of a study is made: claims, and frames in the making, unless
/// a process other than `self` seems to work on some.
void remove_workings(const std::filesystem::path& folder, const std::filesystem::path& now,
                     const std::string& self);

}  // namespace mien::pipeline
