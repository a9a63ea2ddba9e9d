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
  /// Methods of interpolation to evaluate; each synthesizes the targets itself, at the same
  /// parameters. Empty: the method of `interpolation`.
  std::vector<motion::InterpolationMethod> methods;
  std::vector<double> steps = {0.1, 0.25};  ///< slider grids whose nearest settings are tried
  int users = 10;                           ///< simulated, per target and interface
  std::uint64_t seed = 0;
  double threshold = motion::distance_threshold_m;  ///< D below which motions match, metres
};

/// The result of one interface for one target.
struct InterfaceResult {
  motion::InterpolationMethod method = motion::InterpolationMethod::cardinal;
  std::string target;
  InterfaceKind kind = InterfaceKind::adjectives;
  double step = 0.0;            ///< of the grid; 0: a simulated user
  int user = 0;                 ///< from 1; 0: the nearest setting of the grid
  double first_distance = 0.0;  ///< D, metres: the nearest setting, or the user's first guess
  double distance = 0.0;        ///< D in the end, metres
  int views = 1;                ///< motions synthesized and viewed
  bool first_matches = false;
  bool matches = false;  ///< in the end
};

/// Sliders for all primary adjectives, all primary features, and all examples. Adjectives are left
/// out when the examples have no ratings.
std::vector<SliderInterface> interfaces_of(const Repertoire& repertoire);

/// Evaluates each interface on each target by simulation. Targets are points in the primary
/// adjectives, or in the primary features without ratings.
std::vector<InterfaceResult> evaluate_interfaces(const Repertoire& repertoire,
                                                 const std::vector<SampledTarget>& targets,
                                                 const Interpolation& interpolation,
                                                 const EvaluationOptions& options);

/// Summary statistics of an interface.
struct InterfaceSummary {
  motion::InterpolationMethod method = motion::InterpolationMethod::cardinal;
  InterfaceKind kind = InterfaceKind::adjectives;
  double step = 0.0;  ///< of the grid; 0: simulated users
  int count = 0;
  double mean_first = 0.0;     ///< D, metres
  double sd_first = 0.0;       ///< n − 1
  double first_success = 0.0;  ///< share of first guesses below the threshold
  double mean_last = 0.0;
  double sd_last = 0.0;
  double failure = 0.0;  ///< share that never came below the threshold
  double mean_views = 0.0;
};

/// An entry for each method, interface and way, in the order of the results.
std::vector<InterfaceSummary> summarise(const std::vector<InterfaceResult>& results);

WrittenTable results_table(const std::vector<InterfaceResult>& results);
WrittenTable summary_table(const std::vector<InterfaceSummary>& summaries);

/// Bar charts of the summaries, marked as simulated: D of the nearest slider settings and
/// of first guesses with ±1 SD and the threshold, success of first guesses, failures (after figures
/// 7, 8 and 11 of the adjective paper).
Plot simulated_chart(const std::vector<InterfaceSummary>& summaries, double threshold_m);

}  // namespace mien::pipeline
