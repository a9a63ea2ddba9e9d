#pragma once

#include <vector>

#include "pipeline/base/documents/fault.h"
#include "pipeline/manifest/ratings/answers/answer_row.h"
#include "pipeline/manifest/ratings/scales/scales.h"

namespace mien::pipeline {

/// Answers on scales whose value is not what their raw answer gives, turned by the side of the
/// poles. Whether people answered on a slider or on so many points is told by the rows themselves:
/// it is what most of them agree with.
std::vector<Fault> contradicted_values(const std::vector<AnswerRow>& rows, const ScaleSet& scales);

}  // namespace mien::pipeline
