#include "pipeline/base/documents/table.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mien::pipeline {

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
  std::string text = fmt::format(
      "## {}\n\nA row {}.\n\n| column | unit | meaning |\n|---|---|---|\n", form.path, form.rows);
  for (const Column& column : form.columns)
    text += fmt::format("| `{}` | {} | {} |\n", column.name, column.unit, column.meaning);
  return text;
}

std::string given_or_simulated(bool is_simulated) { return is_simulated ? "simulated" : "given"; }

std::string field_text(double number) { return std::isfinite(number) ? shortest(number) : ""; }

}  // namespace mien::pipeline
