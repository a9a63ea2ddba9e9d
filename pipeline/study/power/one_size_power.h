#pragma once

#include <functional>
#include <string>
#include <vector>

#include "pipeline/study/power/planned_power.h"

namespace mien::pipeline {

// The power of planned tests in studies with one number of stimuli per cell: `manifest` has it
// already, `stimuli_per_cell` is stated in the rows. `progress` is called with the share that is
// done.

/// By ratings of single stimuli. Tests in the order of scales, effects before contrasts.
std::vector<PlannedTestPower> rating_power(const Manifest& manifest,
                                           const PlannedPowerOptions& options, int stimuli_per_cell,
                                           const std::function<void(double)>& progress);

/// By choices between two stimuli: of planned contrasts of worths (worths_of), with
/// power_resamples resamples of participants.
std::vector<PlannedTestPower> pair_power(const Manifest& manifest,
                                         const PlannedPowerOptions& options, int stimuli_per_cell,
                                         const std::function<void(double)>& progress);

inline constexpr int power_resamples = 199;

/// The spread of a scale. Throws Error if none is given.
const RatingSpread& spread_for(const std::vector<ScaleSpread>& spreads, const std::string& scale);

/// Sets the shares of studies in which a test was significant with and without a true effect.
void set_power(PlannedTestPower& row, int found, int alarms, int studies);

}  // namespace mien::pipeline
