#include "pipeline/base/documents/table.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "pipeline/base/documents/files.h"

namespace mien::pipeline {

namespace {

constexpr double least_p = 1e-300;
constexpr char below_smallest_p[] = "< 1e-300";

constexpr auto codebook_columns = table_of<DescribedColumn>(
    "codebook.csv", "column of a table",
    {{"table", "", "path of the table", [](auto& r) { return r.table; }},
     {"row_is", "", "what a row of the table is", [](auto& r) { return r.rows; }},
     {"column", "", "name of the column", [](auto& r) { return r.column; }},
     {"unit", "", "unit of its numbers", [](auto& r) { return r.unit; }},
     {"meaning", "", "what it holds", [](auto& r) { return r.meaning; }}});

}  // namespace

std::vector<std::string> header_of(const TableForm& form, const std::vector<std::string>& names) {
  std::vector<std::string> header;
  for (const Column& column : form.columns) {
    if (!column.name.ends_with(column_of_each)) {
      header.emplace_back(column.name);
      continue;
    }
    const std::string_view prefix = column.name.substr(0, column.name.size() - 1);
    for (const std::string& name : names) header.push_back(std::string(prefix) + name);
  }
  return header;
}

const Column* find_column(const TableForm& form, std::string_view name) {
  const auto found = std::ranges::find(form.columns, name, &Column::name);
  return found == form.columns.end() ? nullptr : &*found;
}

std::string markdown_of(const TableForm& form) {
  std::string text =
      fmt::format("## {}\n\nOne row per {}.\n\n| column | unit | meaning |\n|---|---|---|\n",
                  form.path, form.rows);
  for (const Column& column : form.columns)
    text += fmt::format("| `{}` | {} | {} |\n", column.name, column.unit, column.meaning);
  return text;
}

std::string origin_text(bool is_simulated) { return is_simulated ? "simulated" : "given"; }

std::string field_text(double number) { return std::isfinite(number) ? shortest(number) : ""; }

std::string p_field(double p) {
  if (std::isnan(p)) return "";
  return p < least_p ? below_smallest_p : shortest(p);
}

std::string p_label(double p) {
  if (std::isnan(p)) return "–";
  if (p < least_p) return below_smallest_p;
  return p < 0.001 ? fmt::format("{:.1e}", p) : fmt::format("{:.3f}", p);
}

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
