#pragma once

#include <array>
#include <string>

#include "pipeline/base/documents/table.h"
#include "pipeline/manifest/ratings/answers/impressions.h"
#include "pipeline/manifest/ratings/scales/scales.h"

namespace mien::pipeline {

inline constexpr std::array impressions_columns = std::to_array<Column>({
    {"scale", "", "id of the scale"},
    {"low", "", "name of its low end"},
    {"high", "", "name of its high end"},
    {"example", "", "label of the example"},
    {"ratings", "", "whose ratings: given (by people) or simulated"},
    {"answers", "", "number of answers; 1 if only a mean was given"},
    {"mean", "0–1", "mean answer rescaled to 0 (low end) to 1 (high end)"},
    {"sd", "0–1",
     "standard deviation of the answers on the same scale (divisor n, unless mien study analyze "
     "was called with another); empty for given means"},
    {"mean_answer", "scale",
     "mean answer in the units of the scale; on a scale from −2 to 2, negative towards the low "
     "end"},
    {"sd_answer", "scale", "its standard deviation in the same unit; empty for given means"},
});

inline constexpr TableForm impressions_form = {"metrics/impressions.csv", "scale and example",
                                               impressions_columns};

/// What people think of the examples.
std::string impressions_csv(const Impressions& impressions, const ScaleSet& scales);

/// The table of a study that nobody rated.
std::string no_impressions_csv();

}  // namespace mien::pipeline
