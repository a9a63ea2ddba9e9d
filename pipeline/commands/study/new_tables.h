#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace mien::pipeline {

/// A table that a command is about to write.
struct NewTable {
  std::filesystem::path file;  ///< empty: not written
  std::string csv;
};

/// Throws Error before anything is written if a table would overwrite one of `read`, the file of
/// another of `tables` or `archive`, a file that is not an earlier table with the same columns, or
/// answers of participants (simulated is not 1). Other than regular files, such as /dev/stdout, and
/// empty files may be written to.
void refuse_data_loss(const std::vector<NewTable>& tables,
                      const std::vector<std::filesystem::path>& read,
                      const std::filesystem::path& archive = {});

}  // namespace mien::pipeline
