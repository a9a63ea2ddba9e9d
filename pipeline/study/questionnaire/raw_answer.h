#pragma once

#include "pipeline/manifest/questionnaire.h"
#include "pipeline/manifest/ratings/scales/scales.h"

namespace mien::pipeline {

/// Raw answers go from the left, whichever end of the scale is there: 1 … points, or 0 … 100 of a
/// slider.
double least_raw(const AnswerSettings& answer);
double most_raw(const AnswerSettings& answer);

/// The answer in the scale's own range, its high end being the most.
double value_of_raw(const Scale& scale, const AnswerSettings& answer, double raw, bool flipped);

/// The raw answer nearest to a value, within the range.
double raw_of_value(const Scale& scale, const AnswerSettings& answer, double value, bool flipped);

}  // namespace mien::pipeline
