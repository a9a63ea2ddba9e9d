#pragma once

#include <cstdint>
#include <optional>

#include "pipeline/base/adaptive/psychometric_function.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/study/thresholds/track_procedure.h"

namespace mien::pipeline {

/// The psychometric functions of simulated participants in adaptive trials, in units of the factor.
/// What is not set is derived from the levels of the grid.
struct SimulatedObservers {
  std::optional<double> threshold;  ///< their mean; unset: the middle of the levels
  /// Standard deviation of the thresholds of participants; unset: a tenth of the range of levels.
  std::optional<double> threshold_deviation;
  std::optional<double> width;  ///< β of the function; unset: a tenth of the range
  double guess = 0.1;           ///< rate of false alarms; in two-interval trials 0.5 in any case
  double lapse = 0.02;
};

/// The function of one participant, of the ease of levels (TrackProcedure::ease), which gives the
/// questionnaire's proportion of positive answers at the participant's threshold. Deterministic in
/// the seed of the session. Throws Error if no function with these rates has that proportion.
PsychometricFunction simulated_observer(const Manifest& manifest, const TrackProcedure& procedure,
                                        const SimulatedObservers& observers, std::uint64_t seed);

}  // namespace mien::pipeline
