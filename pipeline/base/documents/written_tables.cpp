#include "pipeline/base/documents/written_tables.h"

#include <algorithm>
#include <iterator>

#include "pipeline/base/documents/files.h"

namespace mien::pipeline {

namespace {

constexpr auto codebook_columns = table_of<DescribedColumn>(
    "codebook.csv", "a column of a table",
    {{"table", "", "path of the table", [](auto& r) { return r.table; }},
     {"row_is", "", "what a row of the table is", [](auto& r) { return r.rows; }},
     {"column", "", "name of the column", [](auto& r) { return r.column; }},
     {"unit", "", "unit of its numbers", [](auto& r) { return r.unit; }},
     {"meaning", "", "what it holds", [](auto& r) { return r.meaning; }}});

}  // namespace

std::vector<DescribedColumn> described(const TableForm& form, std::string_view path) {
  std::vector<DescribedColumn> columns;
  for (const auto& [name, unit, meaning] : form.columns)
    columns.push_back({std::string(path), std::string(form.rows), std::string(name),
                       std::string(unit), std::string(meaning)});
  return columns;
}

std::string codebook_csv(const std::vector<DescribedColumn>& columns) {
  return codebook_columns.of(columns).csv;
}

void write_tables(const std::filesystem::path& folder, const std::vector<WrittenTable>& tables) {
  make_folder(folder);
  std::vector<DescribedColumn> book;
  for (const WrittenTable& table : tables) {
    const std::string file = std::filesystem::path(table.form.path).filename().string();
    write_file(folder / file, table.csv);
    std::ranges::move(described(table.form, file), std::back_inserter(book));
  }
  write_file(folder / "codebook.csv", codebook_csv(book));
}

}  // namespace mien::pipeline
