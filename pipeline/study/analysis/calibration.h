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

// How people saw the stimuli that were made for them: what was asked for, what the blend has by the
// ratings of its examples, and what people said of the result.

/// A parameter of a stimulus as it was made.
struct MadeParameter {
  std::string stimulus;
  std::string parameter;
  double requested = 0.0;  ///< 0 low end, 1 high end
  double reached = 0.0;    ///< by the blend
};

/// What was asked for in a study, from its metrics/parameters.csv, or from that file in the study's
/// folder. Warns of columns with former names. Throws Error.
std::vector<MadeParameter> read_made_parameters(const std::filesystem::path& study,
                                                std::vector<Fault>& warnings);

/// The study's other stimuli, of which nothing was asked.
std::set<std::string> other_stimuli(const std::filesystem::path& study,
                                    const std::vector<MadeParameter>& made);

/// The stimuli as answers name them.
std::vector<RatedExample> stimuli_of(const std::vector<MadeParameter>& made);

/// The same parameter as people saw it.
struct PerceivedParameter {
  MadeParameter made;
  int people = 0;
  double perceived = 0.0;  ///< mean over people, share of the range
  double deviation = 0.0;  ///< SD over people (n − 1); NaN for fewer than two
  /// What to ask for in the next round, so that people see what was asked for now; within 0…1.
  std::optional<double> next;
};

/// perceived = intercept + slope · requested, by least squares over the stimuli of a parameter.
struct Correction {
  std::string parameter;
  int stimuli = 0;
  double intercept = 0.0;
  double slope = 0.0;
  double slope_error = 0.0;  ///< standard error; NaN for two stimuli
  double r_squared = 0.0;

  /// What to ask for so that people see `wanted`.
  double ask_for(double wanted) const { return (wanted - intercept) / slope; }
  /// People saw more of it where more was asked for: otherwise there is nothing to correct by.
  bool is_usable() const { return stimuli >= 2 && slope > 0.0; }
};

struct Calibration {
  std::vector<PerceivedParameter> stimuli;  ///< those that somebody rated
  std::vector<Correction> corrections;      ///< one a parameter
  bool simulated = false;
};

/// Throws Error when nobody rated any of the parameters that were asked for.
Calibration calibrate(const std::vector<MadeParameter>& made, const Answers& answers,
                      const ScaleSet& scales);

/// A row a stimulus and parameter.
WrittenTable calibration_table(const Calibration& calibration);

/// A row a parameter.
WrittenTable corrections_table(const Calibration& calibration);

/// A panel a parameter: what people saw (with the standard deviation) over what was asked for, what
/// the blend has, the line of the correction, and the diagonal on which what was requested is seen.
Plot calibration_chart(const Calibration& calibration);

}  // namespace mien::pipeline
