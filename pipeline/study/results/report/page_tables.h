#pragma once

#include <string>

#include "pipeline/study/results/results.h"

namespace mien::pipeline {

// The tables of the page of results as HTML. Each is empty if it has no rows.

std::string sessions_html(const Results& results);
/// How many took part, who is left out and why, the answers to questions about participants, and
/// all sessions.
std::string people_html(const Results& results);
/// The quality rules with what they flagged, and all flags. Empty without quality rules.
std::string quality_html(const Results& results);
/// Lists of flagged participants with the reasons, who are excluded or included.
std::string flagged_people_html(const Results& results);
/// Summary of repeated trials, and all answers to them.
std::string retest_summary_html(const Results& results);
std::string retest_answers_html(const Results& results);
std::string demographics_html(const Results& results);
std::string best_seen_html(const Results& results);
/// The comparisons of a family for the stimuli with this level of the factor `made` (empty: all
/// stimuli). They include only the scales of intended emotions, unless the family has no
/// comparisons on these.
std::string comparisons_html(const Results& results, ComparisonFamily family,
                             const std::string& made = "");
std::string overall_html(const Results& results, ComparisonFamily family);
std::string groups_html(const Results& results);
std::string recall_html(const Results& results, bool by_points);
std::string agreement_html(const Results& results);
std::string preferences_html(const Results& results);
std::string remarks_html(const std::vector<Remark>& remarks);

/// How families of comparisons are formed and corrected in the section of the highest-rated videos
/// and in `others`, by their titles, of the page. `has_overall`: whether these have tables over all
/// settings.
std::string correction_html(const AnswerSet& answer_set, const std::vector<std::string>& others,
                            bool has_overall);

/// The section of the analysis by the factors of the design: method, tables and `figures`. Empty
/// without factors.
std::string factor_section_html(const Results& results, const std::string& figures);

/// The section of the worths of compared stimuli: what they mean, `figures`, and the tables. Empty
/// without comparisons.
std::string worth_section_html(const Results& results, const std::string& figures);

/// The section of the sensitivities in detection: what they mean, `figures`, and the tables. Empty
/// without answers to detection.
std::string detection_section_html(const Results& results, const std::string& figures);

/// The section of the thresholds of adaptive trials: how they are determined, `figures`, and the
/// tables. Empty without such answers.
std::string threshold_section_html(const Results& results, const std::string& figures);

/// The section of grid trials: what they mean, `figures`, and the tables. Empty without such
/// answers.
std::string grid_section_html(const Results& results, const std::string& figures);

/// The section of continuous trials: what they mean, `figures`, and the agreement. Empty without
/// such answers.
std::string trace_section_html(const Results& results, const std::string& figures);

}  // namespace mien::pipeline
