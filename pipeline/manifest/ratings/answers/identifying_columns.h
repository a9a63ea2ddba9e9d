#pragma once

#include <string>
#include <string_view>

#include "pipeline/base/documents/csv.h"

namespace mien::pipeline {

/// Whether a column of answers or participants may identify people: parameters of participants'
/// links and ids of JATOS (is_parameter_column), and closing comments. Neither reports and datasets
/// nor copies of answers that are kept with a study have it.
bool may_identify(std::string_view column);

/// Removes these columns.
void leave_out_what_identifies(CsvTable& table);

/// Returns the text of a table without these columns, or unchanged if it has none. `file` is named
/// in errors. Throws Error as parse_csv does.
std::string without_what_identifies(const std::string& csv, const std::string& file);

}  // namespace mien::pipeline
