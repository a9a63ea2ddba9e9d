#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/manifest/ratings/answers/answer_row.h"
#include "pipeline/study/results/figures/result_figures.h"
#include "pipeline/study/results/result_tables.h"
#include "pipeline/study/results/results.h"

namespace mien::pipeline {

/// The result of the comparison with a frozen design, for the page.
struct FrozenVerdict {
  std::string sentence;  ///< empty: no frozen design was given
  std::vector<std::string> differences;
};

/// Creates the folder of a report, or removes an earlier report from it. Throws Error for a folder
/// that has contents but no report.
void clear_results_folder(const std::filesystem::path& folder);

/// Writes the report: the page report.html, tables (results/), figures (figures/, PDF, SVG and PNG)
/// and their list figures.csv, the data as a Psych-DS dataset and, if there are ratings, R scripts
/// (analysis/). The same answers result in the same bytes. Throws Error and WriteFailure.
void write_results(const Results& results, const std::vector<AnswerRow>& rows,
                   const FrozenVerdict& frozen, const std::filesystem::path& folder);

/// The page report.html: all results, with links to tables and figures. Texts by participants are
/// escaped. The page works from disk, without network access or scripts.
std::string results_page(const Results& results, const std::vector<ResultFigure>& figures,
                         const std::vector<WrittenTable>& tables, const FrozenVerdict& frozen);

}  // namespace mien::pipeline
