#pragma once

#include <filesystem>
#include <vector>

#include "pipeline/base/documents/csv.h"
#include "pipeline/manifest/ratings/answers/answer_rules.h"
#include "pipeline/manifest/ratings/answers/impressions.h"
#include "pipeline/manifest/ratings/scales/scales.h"

namespace mien::pipeline {

/// Reads a tidy CSV: columns stimulus, scale, value; participant unless the values are means;
/// optional rt_ms (milliseconds, ≥ 0), order (a number), comment, simulated; others are ignored. An
/// empty value or "NA" is a missing answer. The answers of a questionnaire (answer_row.h) are read
/// as they are: counted_answers says which count. Stimuli are examples by name or by file stem.
///
/// Missing is also what a participant did not answer about a stimulus that he saw, and, when at
/// least half of the participants saw every example, an example that he did not see. Constant is a
/// participant with at least three answers, all at the same place of their scales.
///
/// Without `examples`, answers are about whatever they name. Of plain ones (rules.plain) the other
/// columns are not looked at, and missing or constant answers are not reported.
///
/// Throws Faults with every fault at once: a column missing, a value that is no number or outside
/// the scale's range, and whatever the rules refuse.
StudyAnswers read_study_answers(const std::filesystem::path& file, const ScaleSet& scales,
                                const std::vector<RatedExample>& examples,
                                const AnswerRules& rules);
StudyAnswers study_answers(const CsvTable& table, const ScaleSet& scales,
                           const std::vector<RatedExample>& examples, const AnswerRules& rules);

}  // namespace mien::pipeline
