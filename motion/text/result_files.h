#pragma once

#include <filesystem>
#include <span>
#include <string>

namespace mien::motion {

/// A file to be written, and its contents.
struct ResultBytes {
  std::filesystem::path target;
  std::string bytes;
};

/// Creates or replaces files that belong together, each like `write_result` (result_file.h). All
/// are complete on the disk before the first of them appears, and the one at the front appears
/// last: where it is new, its companions are there. If one cannot be written, no file is replaced,
/// and none appears. Throws WriteFailure.
void write_results(std::span<const ResultBytes> files);

}  // namespace mien::motion
