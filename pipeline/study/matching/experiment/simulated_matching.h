#pragma once

#include <vector>

#include "pipeline/study/matching/experiment/matching_study.h"
#include "pipeline/study/questionnaire/service/matching_rows.h"

namespace mien::pipeline {

/// Trials that nobody went through: of each plan without its practice, a simulated user
/// (simulated_trial.h) before each target, who takes 20 s to guess and 3 s for each look after it,
/// and gives up at the limit. Sliders are those that are shown at once. Every trial is marked as
/// simulated. Where a target is no blend, its sliders are read as being in the middle.
std::vector<MatchedTrial> simulated_matching(const Manifest& manifest, Motions& motions,
                                             const MatchingStudy& study);

}  // namespace mien::pipeline
