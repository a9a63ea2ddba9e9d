#pragma once

#include <vector>

#include "pipeline/manifest/questionnaire_grid.h"
#include "pipeline/manifest/ratings/answers/answer_row.h"
#include "pipeline/study/results/quality_flags.h"

namespace mien::pipeline {

/// Flags participants by the post-screening of ITU-R BS.1534-3 (2015), section 4.1.2, if the sets
/// have references or anchors:
///
/// - those who rate the hidden reference below 90 in more than 15 % of the trials;
/// - those who rate the anchor above 90 in more than 15 % of the trials. Trials of a set whose
///   anchor more than 25 % of the participants rate above 90 are not counted.
///
/// Only analysed answers (AnswerRow::counts) are considered.
void add_post_screening(const std::vector<GridSet>& sets, const std::vector<AnswerRow>& rows,
                        QualityFlags& flags);

}  // namespace mien::pipeline
