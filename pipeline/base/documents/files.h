#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "motion/text/result_file.h"

namespace mien::pipeline {

using mien::WriteFailure;
using motion::ResultFile;

/// Content of a file written by mien. If it cannot be read, throws std::runtime_error, not Error,
/// because the user's input is not at fault.
std::string read_file(const std::filesystem::path& file);

/// Throws Error if something exists at the path that is not a regular file, since reading a pipe or
/// device might never end.
void refuse_special_file(const std::filesystem::path& file);

/// Creates or replaces a file atomically (ResultFile). Throws WriteFailure, also on a full disk.
void write_file(const std::filesystem::path& file, std::string_view bytes);

/// Replaces a file atomically without flushing it to disk: for records that are rewritten every few
/// seconds. `next` is the path of the temporary file, which does not remain even on failure. Throws
/// WriteFailure if it cannot be written, std::filesystem::filesystem_error if it cannot be renamed.
void replace_file(const std::filesystem::path& file, const std::filesystem::path& next,
                  std::string_view bytes);

/// Entries of a folder in no particular order; empty if it cannot be read. Other processes may be
/// removing entries at the same time.
std::vector<std::filesystem::path> paths_in(const std::filesystem::path& folder);

/// Creates a folder and its parents if they do not exist. Throws WriteFailure.
void make_folder(const std::filesystem::path& folder);

/// Flushes the content of a file or folder to disk. Throws std::system_error.
void flush_to_disk(const std::filesystem::path& file);

}  // namespace mien::pipeline
