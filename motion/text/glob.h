#pragma once

#include <string_view>

namespace mien::motion {

/// Whether a name matches a pattern of `*` (any characters), `?` (any one character), `[abc]`
/// or `[a-z]` (one of these), `[!a]` (any other) and `{walk,run}` (alternatives; may be nested).
/// Case-sensitive.
bool matches_glob(std::string_view pattern, std::string_view name);

}  // namespace mien::motion
