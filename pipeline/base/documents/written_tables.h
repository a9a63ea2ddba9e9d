#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/base/documents/table.h"

namespace mien::pipeline {

/// A column of a table, as codebook.csv has it.
struct DescribedColumn {
  std::string table;  ///< path of the table
  std::string rows;   ///< what a row of it is
  std::string column;
  std::string unit;
  std::string meaning;
};

/// The columns of a form, of a table at `path`.
std::vector<DescribedColumn> described(const TableForm& form, std::string_view path);

std::string codebook_csv(const std::vector<DescribedColumn>& columns);

/// Writes each into the folder, which need not be there yet, under the name of its file, and
/// codebook.csv: what their columns are.
void write_tables(const std::filesystem::path& folder, const std::vector<WrittenTable>& tables);

}  // namespace mien::pipeline
