#pragma once

#include <filesystem>
#include <vector>

#include "pipeline/manifest/ratings/answers/answer_row.h"
#include "pipeline/study/results/report/results_page.h"
#include "pipeline/study/results/results.h"

namespace mien::pipeline {

/// Makes the folder of a report, or leaves nothing of an earlier one in it. Throws Error for a
/// folder that holds anything else: it is not written over.
void clear_results_folder(const std::filesystem::path& folder);

/// Writes everything: the page report.html, tables (results/), drawings (figures/, PDF, SVG and
/// PNG), the data as a Psych-DS dataset and R scripts (analysis/). The same answers give the same
/// bytes. Throws Error and WriteFailure.
void write_results(const Results& results, const std::vector<AnswerRow>& rows,
                   const FrozenVerdict& frozen, const std::filesystem::path& folder);

}  // namespace mien::pipeline
