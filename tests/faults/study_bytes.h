#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace mien::test {

/// File → its bytes.
using Bytes = std::map<std::string, std::string>;

/// What a study's folder holds and is to hold the same after any fault: artifacts and their
/// receipts. What is no regular file shows with its kind as content.
Bytes bytes_in(const std::filesystem::path& folder);

/// What distinguishes a folder from one that was made undisturbed: "videos/one.mp4 is missing",
/// "… differs", "… was left behind".
std::vector<std::string> differences(const Bytes& undisturbed, const Bytes& found);

/// What nobody needs once everything is made: attempts, claims, frames in the making, files of
/// which only a part was written. As paths.
std::vector<std::string> leftovers(const std::filesystem::path& folder);

}  // namespace mien::test
