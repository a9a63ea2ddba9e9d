#pragma once

#include <filesystem>
#include <vector>

#include "pipeline/base/documents/csv.h"
#include "pipeline/manifest/ratings/answers/answer_rules.h"
#include "pipeline/manifest/ratings/answers/impressions.h"
#include "pipeline/manifest/ratings/scales/scales.h"

namespace mien::pipeline {

/// Reads a tidy CSV with the columns stimulus, scale and value, participant unless the values are
/// means, and optionally rt_ms (milliseconds, ≥ 0), order (a number), comment and simulated; other
/// columns are ignored. An empty value or "NA" is a missing answer. The answers of a questionnaire
/// (answer_row.h) are accepted as written; counted_answers selects those that count. Stimuli are
/// examples, by name or file stem.
///
/// An answer is also missing if a participant left out a scale of a stimulus that they saw. If at
/// least half of the participants saw every example, answers of the other participants about
/// examples that they did not see are missing too. A participant is constant if they gave at least
/// three answers, all at the same position on their scales.
///
/// If `examples` is empty, any stimulus is accepted. For plain answers (rules.plain), rt_ms, order
/// and comment are ignored too, and neither missing answers nor constant participants are reported.
///
/// Throws Error for a missing column or a table of words (word_answers.h), and Faults with every
/// fault of the rows at once: numbers that are malformed, values outside the scale's range,
/// negative response times, and everything that the rules refuse.
StudyAnswers read_study_answers(const std::filesystem::path& file, const ScaleSet& scales,
                                const std::vector<RatedExample>& examples,
                                const AnswerRules& rules);
StudyAnswers study_answers(const CsvTable& table, const ScaleSet& scales,
                           const std::vector<RatedExample>& examples, const AnswerRules& rules);

}  // namespace mien::pipeline
