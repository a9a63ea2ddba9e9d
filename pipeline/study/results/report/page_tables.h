#pragma once

#include <string>

#include "pipeline/study/results/results.h"

namespace mien::pipeline {

// The tables of the page of results, as HTML; empty where there is nothing to tell.

std::string sessions_html(const Results& results);
/// Of catch trials: what is summed up, and every answer.
std::string catch_summary_html(const Results& results);
std::string catch_answers_html(const Results& results);
std::string demographics_html(const Results& results);
std::string best_seen_html(const Results& results);
/// Of a family; of best_seen the videos of one group (result_figures.h) alone, on the scale of the
/// emotion that was meant or, where there is none, on all.
std::string comparisons_html(const Results& results, ComparisonFamily family,
                             const std::string& made = "");
std::string overall_html(const Results& results, ComparisonFamily family);
std::string groups_html(const Results& results);
std::string recall_html(const Results& results);
std::string agreement_html(const Results& results);
std::string preferences_html(const Results& results);
std::string remarks_html(const std::vector<Remark>& remarks);

}  // namespace mien::pipeline
