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

/// Throws Error, before anything is written, if a table would overwrite (1) one of the files in
/// `read`, (2) another table in `tables`, (3) `archive`, another file that the command is about to
/// write (empty: none), (4) an existing file that is not an earlier table with the same columns, or
/// (5) answers of real participants (rows whose column `simulated` is not 1). Empty files and files
/// that are not regular, such as /dev/stdout, may be overwritten.
void refuse_data_loss(const std::vector<NewTable>& tables,
                      const std::vector<std::filesystem::path>& read,
                      const std::filesystem::path& archive = {});

/// Throws Error if a file exists with other bytes, so that a registered archive or an edited
/// manifest is not overwritten.
void refuse_other_content(const std::filesystem::path& file, const std::string& bytes);

}  // namespace mien::pipeline
