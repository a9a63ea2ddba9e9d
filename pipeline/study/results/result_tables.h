#pragma once

#include <string>
#include <vector>

#include "pipeline/base/documents/table.h"
#include "pipeline/study/results/results.h"

namespace mien::pipeline {

/// All tables of results that have rows. A last column `simulated` is added where the answers are
/// simulated.
std::vector<WrittenTable> result_tables(const Results& results);

/// A number as text for a table; empty for NaN and infinity.
std::string number_field(double value);

}  // namespace mien::pipeline
