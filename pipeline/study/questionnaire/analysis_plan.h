#pragma once

#include <string>

#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// analysis-plan.txt of a frozen design: the plan as the manifest has it, followed by how it is
/// tested, by factors and contrasts, by the quality rules, and by what the report computes in any
/// case. The manifest must have a questionnaire.
std::string analysis_plan_text(const Manifest& manifest);

/// The manifest's own plan in such a file. What follows it is in design.json too.
std::string stated_plan_in(const std::string& analysis_plan);

}  // namespace mien::pipeline
