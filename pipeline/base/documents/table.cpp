#include "pipeline/base/documents/table.h"

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

}  // namespace mien::pipeline
