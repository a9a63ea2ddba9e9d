#pragma once

#include <string>

#include "pipeline/study/results/results.h"

namespace mien::pipeline {

// The tables of the page of results, as HTML; empty without rows.

std::string sessions_html(const Results& results);
/// Repeated trials: the summary, and all answers.
std::string catch_summary_html(const Results& results);
std::string catch_answers_html(const Results& results);
std::string demographics_html(const Results& results);
std::string best_seen_html(const Results& results);
/// The comparisons of a family. In best_seen only the videos of one group (result_figures.h), on
/// the scale of the intended emotion, or on all scales without one.
std::string comparisons_html(const Results& results, ComparisonFamily family,
                             const std::string& made = "");
std::string overall_html(const Results& results, ComparisonFamily family);
std::string groups_html(const Results& results);
std::string recall_html(const Results& results);
std::string agreement_html(const Results& results);
std::string preferences_html(const Results& results);
std::string remarks_html(const std::vector<Remark>& remarks);

}  // namespace mien::pipeline
