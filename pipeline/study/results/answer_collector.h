#pragma once

#include <vector>

#include "pipeline/base/documents/fault.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/manifest/ratings/answers/answer_row.h"
#include "pipeline/study/results/answer_set.h"

namespace mien::pipeline {

/// Checks rows against the manifest's questionnaire and adds those that are analysed to `result`,
/// whose stimuli, scales, participants and quality flags must have been set. Returns all faults.
std::vector<Fault> check_and_collect(const Manifest& manifest, const std::vector<AnswerRow>& rows,
                                     AnswerSet& result);

}  // namespace mien::pipeline
