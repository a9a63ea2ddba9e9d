#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "pipeline/base/documents/fault.h"
#include "pipeline/base/documents/table.h"
#include "pipeline/base/drawing/plot.h"
#include "pipeline/manifest/ratings/answers/answers.h"
#include "pipeline/manifest/ratings/answers/impressions.h"
#include "pipeline/manifest/ratings/scales/scales.h"

namespace mien::pipeline {

// Calibration of stimuli by ratings: compares the requested parameters with those of the blended
// motion (from the ratings of its examples) and with those perceived by participants.

/// A parameter of a synthesized stimulus.
struct StimulusParameter {
  std::string stimulus;
  std::string parameter;
  double requested = 0.0;  ///< 0 low end, 1 high end
  double reached = 0.0;    ///< value of the blend, from its examples' ratings; same range
};

/// Reads the parameters of a study's stimuli. `study` is the study's folder, or the file
/// metrics/parameters.csv in it. Adds warnings about columns with former names to `warnings`.
/// Throws Error.
std::vector<StimulusParameter> read_stimulus_parameters(const std::filesystem::path& study,
                                                        std::vector<Fault>& warnings);

/// The ids of the study's stimuli without requested parameters.
std::set<std::string> other_stimuli(const std::filesystem::path& study,
                                    const std::vector<StimulusParameter>& made);

/// The distinct stimuli of `made`, with the ids that answers use.
std::vector<RatedExample> stimuli_of(const std::vector<StimulusParameter>& made);

/// A requested parameter with its perceived value.
struct PerceivedParameter {
  StimulusParameter made;
  int people = 0;
  double perceived = 0.0;  ///< mean over participants, 0 to 1 of the scale's range
  double deviation = 0.0;  ///< SD over participants (n − 1); NaN for fewer than two
  /// The value to request in the next round so that `requested` is perceived, clamped to 0 … 1;
  /// empty if the correction is unusable.
  std::optional<double> next;
};

/// The line perceived = intercept + slope · requested, fitted by least squares over the stimuli of
/// one parameter. If all requested values are equal, the slope is 0 and the intercept the mean
/// perceived value.
struct Correction {
  std::string parameter;
  int stimuli = 0;
  double intercept = 0.0;
  double slope = 0.0;
  double slope_error = 0.0;  ///< standard error of the slope; NaN for fewer than three stimuli or
                             ///< equal requested values
  /// NaN if all requested values or all perceived values are equal.
  double r_squared = 0.0;

  /// The value to request so that `wanted` is perceived.
  double request_for(double wanted) const { return (wanted - intercept) / slope; }
  /// Whether the perceived value increases with the requested one, so that the line can be
  /// inverted.
  bool is_usable() const { return stimuli >= 2 && slope > 0.0; }
};

struct Calibration {
  std::vector<PerceivedParameter> stimuli;  ///< the requested parameters that were rated
  std::vector<Correction> corrections;      ///< one per rated parameter
  bool simulated = false;
};

/// Fits the corrections. Throws Error if none of the requested parameters was rated.
Calibration calibrate(const std::vector<StimulusParameter>& made, const Answers& answers,
                      const ScaleSet& scales);

/// A row for each stimulus and parameter.
WrittenTable calibration_table(const Calibration& calibration);

/// A row for each parameter.
WrittenTable corrections_table(const Calibration& calibration);

/// A panel for each parameter: perceived (with standard deviation) over requested values, the
/// values of the blend, the regression line if it is usable, and the diagonal of perfect agreement.
Plot calibration_chart(const Calibration& calibration);

}  // namespace mien::pipeline
