#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/manifest/ratings/answers/answer_row.h"
#include "pipeline/study/results/figures/result_figures.h"
#include "pipeline/study/results/result_tables.h"
#include "pipeline/study/results/results.h"

namespace mien::pipeline {

/// What the page says of a frozen design: a sentence, and what differs from it.
struct FrozenVerdict {
  std::string sentence;  ///< empty: was not asked for
  std::vector<std::string> differences;
};

/// Makes the folder of a report, or leaves nothing of an earlier one in it. Throws Error for a
/// folder that holds anything else: it is not written over.
void clear_results_folder(const std::filesystem::path& folder);

/// Writes everything: the page report.html, tables (results/), drawings (figures/, PDF, SVG and
/// PNG), the data as a Psych-DS dataset and R scripts (analysis/). The same answers give the same
/// bytes. Throws Error and WriteFailure.
void write_results(const Results& results, const std::vector<AnswerRow>& rows,
                   const FrozenVerdict& frozen, const std::filesystem::path& folder);

/// The page report.html: everything that was found, with links to tables and drawings beside it.
/// Whatever participants wrote is escaped. Works from disk, without a network and without scripts.
std::string results_page(const Results& results, const std::vector<ResultFigure>& figures,
                         const std::vector<WrittenTable>& tables, const FrozenVerdict& frozen);

}  // namespace mien::pipeline
