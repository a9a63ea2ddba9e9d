#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "motion/text/result_file.h"

namespace mien::pipeline {

using mien::WriteFailure;
using motion::ResultFile;

/// All of a file of ours. Throws std::runtime_error: that it cannot be read is no fault of what the
/// user wrote.
std::string read_file(const std::filesystem::path& file);

/// Throws Error where something else than a regular file is: reading it might never end.
void refuse_what_is_no_file(const std::filesystem::path& file);

/// Creates or replaces a file, as ResultFile does. Throws WriteFailure, also when the disk is full.
void write_file(const std::filesystem::path& file, std::string_view bytes);

/// Likewise at once, but without waiting for the disk: for records that are written anew every few
/// seconds. `next` is where they are written first; it is not there afterwards, whatever happens.
void replace_file(const std::filesystem::path& file, const std::filesystem::path& next,
                  std::string_view bytes);

/// What lies in a folder just now, in no order; nothing where it cannot be read. Others may be
/// clearing it away.
std::vector<std::filesystem::path> paths_in(const std::filesystem::path& folder);

/// Makes a folder and those above it, unless they are there. Throws WriteFailure.
void make_folder(const std::filesystem::path& folder);

/// Waits until a file's (or a folder's) content is on the disk. Throws std::system_error.
void flush_to_disk(const std::filesystem::path& file);

}  // namespace mien::pipeline
