#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace mien::motion {

/// The bytes of a file or of what a pipe brings; nothing when it is missing, a folder or
/// unreadable.
std::optional<std::string> bytes_of_file(const std::filesystem::path& path);

/// The bytes of a motion's file. Throws mien::Error when it is missing, not a regular file or
/// unreadable.
std::string read_contents(const std::filesystem::path& path);

/// Writes the bytes, replacing a file of that name. Throws mien::Error when that fails.
void write_contents(const std::filesystem::path& path, std::string_view bytes);

}  // namespace mien::motion
