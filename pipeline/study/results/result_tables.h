#pragma once

#include <string>
#include <vector>

#include "pipeline/base/documents/table.h"
#include "pipeline/study/results/results.h"

namespace mien::pipeline {

/// All tables that the answers make possible: those without rows are left out. Each has a last
/// column simulated where the answers are.
std::vector<WrittenTable> result_tables(const Results& results);

/// A number for a table: nothing where it is not known, or without end.
std::string field_of(double value);

}  // namespace mien::pipeline
