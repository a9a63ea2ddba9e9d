#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace mien::motion {

/// Whether a file name matches a pattern of `*` (any characters), `?` (any one), `[abc]`, `[a-z]`,
/// `[!a]` (one of, one not of) and `{walk,run}` (either; may be nested). Upper and lower case
/// differ.
bool matches_glob(std::string_view pattern, std::string_view name);

/// Short labels for files that belong together: the common prefix and suffix of all stems (names
/// without extension) are removed, in whole parts between "_", "." and spaces.
/// {"dataset-1_walk_sad_001", "dataset-1_walk_proud_001"} gives {"sad", "proud"}. A single stem
/// stays as it is.
std::vector<std::string> labels_from_names(std::span<const std::string> stems);

}  // namespace mien::motion
