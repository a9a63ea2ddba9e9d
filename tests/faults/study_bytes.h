#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace mien::test {

/// File → its bytes.
using Bytes = std::map<std::string, std::string>;

/// The files of a study's folder that must be identical after any fault: artifacts and receipts.
/// Other than regular files appear with their type as content.
Bytes bytes_in(const std::filesystem::path& folder);

/// Differences of a folder from that of an undisturbed run: "videos/one.mp4 is missing",
/// "… differs", "… was left behind".
std::vector<std::string> differences(const Bytes& undisturbed, const Bytes& found);

/// Paths of files that are obsolete in a complete study: attempts, claims, unpublished frames and
/// partially written files.
std::vector<std::string> leftovers(const std::filesystem::path& folder);

}  // namespace mien::test
