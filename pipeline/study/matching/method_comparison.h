#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pipeline/base/documents/table.h"
#include "pipeline/production/synthesis/repertoire.h"
#include "pipeline/production/synthesis/slider_interface.h"

namespace mien::pipeline {

struct MethodComparisonOptions {
  int settings = 50;  ///< number of random requests
  int steps = 100;    ///< interpolation steps between successive requests
  std::uint64_t seed = 0;
};

/// Accuracy and smoothness of an interpolation method for feasible requests, measured as by Feng,
/// Huang, Kallmann and Shapiro (2012), and D to the intended motions.
struct MethodResult {
  motion::InterpolationMethod method = motion::InterpolationMethod::reach;
  int settings = 0;  ///< number of requests
  /// Mean over requests of the largest |reached − requested| of a parameter.
  double mean_error = 0.0;
  double worst_error = 0.0;    ///< largest of these errors
  double jump = 0.0;           ///< largest change of a weight in one step between requests
  double mean_examples = 0.0;  ///< mean effective number of blended examples, 1 / Σ w²
  double mean_distance = 0.0;  ///< mean D to the blend that has the requested parameters, metres
  double seconds = 0.0;        ///< mean computing time of the weights of a request
};

/// Evaluates each method with sliders for `parameters` (names of rated scales or groups). A request
/// consists of the parameters of a random blend of three examples, drawn with replacement; it is
/// therefore reachable. D is measured to this blend. Throws Error if a method does not support that
/// number of parameters.
std::vector<MethodResult> compare_methods(const Repertoire& repertoire,
                                          const std::vector<std::string>& parameters,
                                          const std::vector<motion::InterpolationMethod>& methods,
                                          const Interpolation& interpolation,
                                          const MethodComparisonOptions& options);

/// A row for each method, without the computing times, which are not reproducible.
WrittenTable method_results_table(const std::vector<MethodResult>& trials, bool simulated_ratings);

}  // namespace mien::pipeline
