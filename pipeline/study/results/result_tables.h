#pragma once

#include <string>
#include <vector>

#include "pipeline/base/documents/table.h"
#include "pipeline/study/results/results.h"

namespace mien::pipeline {

/// All tables of results that have rows. If the answers are simulated, each has a last column
/// `simulated`.
std::vector<WrittenTable> result_tables(const Results& results);

/// A number as text for a table; empty for NaN and infinity.
std::string number_field(double value);

}  // namespace mien::pipeline
