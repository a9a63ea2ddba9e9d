#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace mien::pipeline {

/// 128-bit content hash (XXH3), 32 hexadecimal digits.
using Hash = std::string;

Hash hash_of(std::string_view bytes);

/// Throws Error for a pipe, a device or the like, and std::system_error when the file cannot be
/// read.
Hash hash_of_file(const std::filesystem::path& file);

}  // namespace mien::pipeline
