#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace mien::pipeline {

/// All of a file of ours. Throws std::runtime_error: that it cannot be read is no fault of what the
/// user wrote.
std::string read_file(const std::filesystem::path& file);

/// Throws Error where something else than a regular file is: reading it might never end.
void refuse_what_is_no_file(const std::filesystem::path& file);

/// Creates or replaces a file. Throws std::runtime_error, also when the disk is full.
void write_file(const std::filesystem::path& file, std::string_view bytes);

/// Makes a folder and those above it, unless they are there. Throws std::runtime_error.
void make_folder(const std::filesystem::path& folder);

/// Waits until a file's (or a folder's) content is on the disk. Throws std::system_error.
void flush_to_disk(const std::filesystem::path& file);

/// Waits until everything written to the file system that holds `folder` is on the disk.
void flush_file_system(const std::filesystem::path& folder);

}  // namespace mien::pipeline
