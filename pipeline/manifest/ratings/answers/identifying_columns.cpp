#include "pipeline/manifest/ratings/answers/identifying_columns.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "pipeline/manifest/ratings/answers/answer_row.h"

namespace mien::pipeline {

namespace {

std::vector<std::string> texts_of(const std::vector<CsvField>& fields) {
  std::vector<std::string> texts;
  for (const CsvField& field : fields) texts.push_back(field.text);
  return texts;
}

}  // namespace

bool may_identify(std::string_view column) {
  return is_parameter_column(column) || column == "closing_comment";
}

void leave_out_what_identifies(CsvTable& table) {
  for (std::size_t column = table.header.size(); column-- > 0;) {
    if (!may_identify(table.header[column].text)) continue;
    const auto at = static_cast<std::ptrdiff_t>(column);
    table.header.erase(table.header.begin() + at);
    for (std::vector<CsvField>& row : table.rows) row.erase(row.begin() + at);
  }
}

std::string without_what_identifies(const std::string& csv, const std::string& file) {
  CsvTable table = parse_csv(csv, file);
  if (std::ranges::none_of(table.header, may_identify, &CsvField::text)) return csv;
  leave_out_what_identifies(table);
  CsvWriter writer(texts_of(table.header));
  for (const std::vector<CsvField>& row : table.rows) writer.row(texts_of(row));
  return writer.text();
}

}  // namespace mien::pipeline
