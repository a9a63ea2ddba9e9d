#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/base/documents/csv.h"

namespace mien::pipeline {

/// A column of a table of results.
struct Column {
  std::string_view name;
  std::string_view unit;     ///< "m", "0–1"; empty for names, texts and plain counts
  std::string_view meaning;  ///< a sentence without its full stop; how signs are to be read
};

/// What a table of results holds: the one list of its columns, which the table is written by and
/// the study's codebook tells.
struct TableForm {
  std::string_view path;  ///< "metrics/distances.csv"
  std::string_view rows;  ///< what a row is of: "compared pair"
  std::span<const Column> columns;
};

/// A column of which a study may have any number, `<prefix><name>` each.
inline constexpr std::string_view column_of_each = "*";

/// The columns' names. A column `factor_*` stands for one of each of `names`.
std::vector<std::string> header_of(const TableForm& form,
                                   const std::vector<std::string>& names = {});

/// A table of that form, without rows.
inline CsvWriter table_of(const TableForm& form) { return CsvWriter(header_of(form)); }

}  // namespace mien::pipeline
