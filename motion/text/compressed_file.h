#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "motion/text/file_contents.h"

namespace mien::motion {

/// Whether bytes begin as those of a gzip file.
inline bool is_gzip(std::string_view bytes) { return bytes.starts_with("\x1f\x8b"); }

/// The path to take the ending from: "walk.bvh" of "walk.bvh.gz"; any other path is unchanged.
std::filesystem::path without_compression(const std::filesystem::path& path);

/// The name of a file's recording: "walk" of "walk.bvh.gz", "walk_000000000012_keypoints.json".
std::string recording_name(const std::filesystem::path& path);

/// The most that a gzip file of `bytes` is inflated to: fifty times its size, but at least
/// 8 MiB and at most `most_bytes`. Text of motions shrinks to a third or a tenth, so more is a
/// sign of a file made to exhaust the memory.
std::uintmax_t largest_inflated(std::uintmax_t bytes, std::uintmax_t most_bytes);

/// The contents of a gzip file (RFC 1952) of one or several members, one after the other; zeros at
/// the end are ignored. Memory stays below twice the limit. Throws mien::Error naming the file if
/// it is truncated or damaged, or has more than `largest_inflated` in it.
std::string inflated(std::string_view bytes, const std::string& file_name,
                     std::uintmax_t most_bytes = max_recording_bytes);

}  // namespace mien::motion
