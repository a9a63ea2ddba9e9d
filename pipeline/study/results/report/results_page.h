#pragma once

#include <string>
#include <vector>

#include "pipeline/study/results/figures/result_figures.h"
#include "pipeline/study/results/result_tables.h"
#include "pipeline/study/results/results.h"

namespace mien::pipeline {

/// What the page says of a frozen design: a sentence, and what differs from it.
struct FrozenVerdict {
  std::string sentence;  ///< empty: was not asked for
  std::vector<std::string> differences;
};

/// The page report.html: everything that was found, with links to tables and drawings beside it.
/// Whatever participants wrote is escaped. Works from disk, without a network and without scripts.
std::string results_page(const Results& results, const std::vector<ResultFigure>& figures,
                         const std::vector<WrittenTable>& tables, const FrozenVerdict& frozen);

}  // namespace mien::pipeline
