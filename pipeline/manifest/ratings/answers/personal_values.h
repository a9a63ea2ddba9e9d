#pragma once

#include <map>
#include <string>

#include "pipeline/manifest/ratings/answers/answers.h"
#include "pipeline/manifest/ratings/answers/impressions.h"
#include "pipeline/manifest/ratings/scales/scales.h"

namespace mien::pipeline {

/// What each participant said of an example: participant → share of the scale's range, 0 low end,
/// 1 high end; of a group of scales the mean of those that the participant answered. Answers that
/// are means of several people are left out.
std::map<std::string, double> personal_values(const Answers& answers, const ScaleSet& scales,
                                              const RatedExample& example,
                                              const std::string& parameter);

}  // namespace mien::pipeline
