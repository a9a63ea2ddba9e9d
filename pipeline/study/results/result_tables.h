#pragma once

#include <string>
#include <vector>

#include "pipeline/base/documents/table.h"
#include "pipeline/study/results/results.h"

namespace mien::pipeline {

/// A table of results with its form, so that a codebook can be made of it.
struct ResultTable {
  const TableForm* form;
  std::string csv;
};

/// All tables that the answers make possible: those without rows are left out. Each has a last
/// column simulated where the answers are.
std::vector<ResultTable> result_tables(const Results& results);

/// A number for a table: nothing where it is not known, or without end.
std::string field_of(double value);

}  // namespace mien::pipeline
