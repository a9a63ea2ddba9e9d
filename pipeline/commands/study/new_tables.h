#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace mien::pipeline {

/// A table that a command is about to write.
struct NewTable {
  std::filesystem::path file;  ///< empty: it is not wanted
  std::string csv;
};

/// Throws Error, and nothing has been written then, where a table would go into one of `read`, into
/// the same file as another of `tables` or as `archive`, into a file that is no earlier table of
/// the same columns, or into answers that people gave (simulated is not 1). What is no regular
/// file, as /dev/stdout, and what is empty may be written to.
void refuse_losing_files(const std::vector<NewTable>& tables,
                         const std::vector<std::filesystem::path>& read,
                         const std::filesystem::path& archive = {});

}  // namespace mien::pipeline
