#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/study/power/power_output.h"
#include "pipeline/study/results/comparisons.h"

namespace mien::pipeline {

namespace {

double in_thousandths(double value) { return std::round(1000.0 * value) / 1000.0; }

std::string spread_text(const ScaleSpread& scale) {
  const RatingSpread& spread = scale.spread;
  return fmt::format("{}participants {:g}, stimuli {:g}, participants in cells {:g}, residual {:g}",
                     scale.scale.empty() ? "" : scale.scale + ": ",
                     in_thousandths(spread.participant), in_thousandths(spread.stimulus),
                     in_thousandths(spread.participant_by_cell), in_thousandths(spread.residual));
}

std::string effect_text(const PlannedPowerOptions& options) {
  if (options.truth) return "Assumed effects: those of the stated true ratings.";
  return fmt::format(
      "Assumed effects: {:g} point{} in one test at a time, and none in the other tests.",
      options.difference, options.difference == 1.0 ? "" : "s");
}

std::string correction_text(const AnalysisPlan& plan) {
  if (plan.correction == TestCorrection::none) return "not corrected for multiple comparisons";
  return fmt::format("corrected within the effects and within the planned contrasts ({})",
                     name_of(plan.correction));
}

}  // namespace

std::vector<std::string> power_assumptions(const Manifest& manifest,
                                           const PlannedPowerOptions& options) {
  std::string spreads;
  for (const ScaleSpread& scale : options.spreads)
    spreads += (spreads.empty() ? "" : "; ") + spread_text(scale);
  const AnalysisPlan& plan = questionnaire_of(manifest).analysis;
  return {effect_text(options), fmt::format("Assumed standard deviations, points: {}.", spreads),
          fmt::format("{} simulated studies of each size. Tests with α = {:g}; p values {}.",
                      options.studies, plan.alpha, correction_text(plan))};
}

}  // namespace mien::pipeline
