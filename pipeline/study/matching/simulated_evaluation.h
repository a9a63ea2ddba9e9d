#pragma once

#include <string>
#include <vector>

#include "pipeline/base/documents/table.h"
#include "pipeline/base/drawing/plot.h"
#include "pipeline/production/synthesis/slider_interface.h"
#include "pipeline/study/matching/simulated_trial.h"
#include "pipeline/study/matching/target_sampling.h"

namespace mien::pipeline {

struct EvaluationOptions {
  /// Interpolation methods to evaluate. Each method synthesizes the targets from the same
  /// parameters. Empty: the method of `interpolation`.
  std::vector<motion::InterpolationMethod> methods;
  /// Steps of slider grids. Of each grid, the setting nearest to the ideal one for the target is
  /// tried.
  std::vector<double> steps = {0.1, 0.25};
  int users = 10;  ///< number of simulated users per target, interface and method
  std::uint64_t seed = 0;
  double threshold = motion::distance_threshold_m;  ///< D below which motions match, metres
};

/// The result of one interface for one target.
struct InterfaceResult {
  motion::InterpolationMethod method = motion::InterpolationMethod::cardinal;
  std::string target;
  InterfaceKind kind = InterfaceKind::adjectives;
  double step = 0.0;  ///< step of the grid; 0: a simulated user
  int user = 0;       ///< number of the simulated user, from 1; 0: nearest setting of a grid
  /// D of the nearest grid setting, or of the first guess of a simulated user, metres.
  double first_distance = 0.0;
  double distance = 0.0;       ///< final D, metres
  int views = 1;               ///< motions synthesized and viewed
  bool first_matches = false;  ///< first_distance is below the threshold
  bool matches = false;        ///< the final D is below the threshold
};

/// Three interfaces: with a slider for each primary adjective, for each primary feature, and for
/// the weight of each example. The first is omitted if the examples have no ratings.
std::vector<SliderInterface> interfaces_of(const Repertoire& repertoire);

/// Evaluates each interface on each target by simulation. Targets are points in the space of the
/// primary adjectives, or of the primary features if the examples have no ratings.
std::vector<InterfaceResult> evaluate_interfaces(const Repertoire& repertoire,
                                                 const std::vector<SampledTarget>& targets,
                                                 const Interpolation& interpolation,
                                                 const EvaluationOptions& options);

/// Summary statistics of an interface. Distances are D in metres.
struct InterfaceSummary {
  motion::InterpolationMethod method = motion::InterpolationMethod::cardinal;
  InterfaceKind kind = InterfaceKind::adjectives;
  double step = 0.0;           ///< step of the grid; 0: simulated users
  int count = 0;               ///< number of results
  double mean_first = 0.0;     ///< first distance
  double sd_first = 0.0;       ///< with divisor n − 1; 0 for one result
  double first_success = 0.0;  ///< share of first guesses below the threshold
  double mean_last = 0.0;      ///< final distance
  double sd_last = 0.0;        ///< with divisor n − 1; 0 for one result
  double failure = 0.0;        ///< share of results that did not match
  double mean_views = 0.0;
};

/// A summary for each method, interface and step, in the order of their first results.
std::vector<InterfaceSummary> summarise(const std::vector<InterfaceResult>& results);

WrittenTable results_table(const std::vector<InterfaceResult>& results);
WrittenTable summary_table(const std::vector<InterfaceSummary>& summaries);

/// Bar charts of the summaries, marked as simulated: D of the nearest grid settings and of first
/// guesses with ±1 SD and the threshold, success of first guesses, and failures of the simulated
/// users (like figures 7, 8 and 11 of the adjective paper).
Plot simulated_chart(const std::vector<InterfaceSummary>& summaries, double threshold_m);

}  // namespace mien::pipeline
