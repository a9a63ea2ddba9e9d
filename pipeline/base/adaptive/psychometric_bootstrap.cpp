#include "pipeline/base/adaptive/psychometric_bootstrap.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "motion/math/random_number.h"

namespace mien::pipeline {

namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();
constexpr IntervalEnds unknown_ends = {std::numeric_limits<double>::quiet_NaN(),
                                       std::numeric_limits<double>::quiet_NaN()};

std::vector<LevelCount> drawn_counts(const PsychometricFunction& function,
                                     std::vector<LevelCount> counts, std::uint64_t stream) {
  std::uint64_t n = 0;
  for (LevelCount& count : counts) {
    const double probability = answer_probability(function, count.level).positive;
    count.positive = 0;
    for (int i = 0; i < count.trials; ++i)
      count.positive +=
          motion::open_unit_number(motion::random_bits(stream, n++)) < probability ? 1 : 0;
  }
  return counts;
}

/// The least and the largest value that each resample may have.
class ResampledValues {
 public:
  void add(double value) { add({value, value}); }

  void add(IntervalEnds range) {
    lows_.push_back(std::isnan(range.low) ? -unlimited : range.low);
    highs_.push_back(std::isnan(range.high) ? unlimited : range.high);
  }

  IntervalEnds ends(double confidence) {
    const auto count = static_cast<double>(lows_.size());
    // The addition keeps ranks that are whole numbers from being rounded down.
    const auto rank = static_cast<std::size_t>((count + 1.0) * 0.5 * (1.0 - confidence) + 1e-9);
    if (rank < 1) return unknown_ends;
    std::ranges::sort(lows_);
    std::ranges::sort(highs_);
    return {finite(lows_[rank - 1]), finite(highs_[highs_.size() - rank])};
  }

 private:
  static double finite(double end) { return std::isinf(end) ? unknown_ends.low : end; }

  std::vector<double> lows_;
  std::vector<double> highs_;
};

struct AllValues {
  ResampledValues threshold, slope, location, width, guess, lapse;

  void add(const PsychometricFit& fit, double proportion) {
    const PsychometricFunction& function = fit.function;
    if (fit.problem == FitProblem::step) {
      threshold.add(fit.step);
      slope.add(unlimited);
      location.add(fit.step);
      width.add(0.0);
    } else {
      const double level = level_at(function, proportion);
      threshold.add(level);
      slope.add(slope_at(function, level));
      location.add(function.location);
      width.add(function.width);
    }
    guess.add(function.guess);
    lapse.add(function.lapse);
  }
};

}  // namespace

PsychometricBootstrap psychometric_bootstrap(const PsychometricFit& fit,
                                             const std::vector<LevelCount>& all_counts,
                                             const PsychometricModel& model,
                                             const BootstrapRequest& request, std::uint64_t seed) {
  PsychometricBootstrap result{unknown_ends, unknown_ends, unknown_ends,    unknown_ends,
                               unknown_ends, unknown_ends, unknown_ends.low};
  if (fit.problem != FitProblem::none) return result;
  const std::vector<LevelCount> counts = pooled_levels(all_counts);
  AllValues values;
  int not_better = 0;
  for (int n = 0; n < request.resamples; ++n) {
    const std::uint64_t stream = motion::random_bits(seed, static_cast<std::uint64_t>(n));
    const PsychometricFit resampled =
        psychometric_fit(drawn_counts(fit.function, counts, stream), model);
    values.add(resampled, request.proportion);
    not_better += resampled.deviance >= fit.deviance ? 1 : 0;
    result.steps += resampled.problem == FitProblem::step ? 1 : 0;
    result.without_estimate +=
        resampled.problem != FitProblem::none && resampled.problem != FitProblem::step ? 1 : 0;
  }
  result.threshold = values.threshold.ends(request.confidence);
  result.slope = values.slope.ends(request.confidence);
  result.location = values.location.ends(request.confidence);
  result.width = values.width.ends(request.confidence);
  result.guess = values.guess.ends(request.confidence);
  result.lapse = values.lapse.ends(request.confidence);
  result.resamples = request.resamples;
  result.deviance_p = (1.0 + not_better) / (request.resamples + 1.0);
  return result;
}

}  // namespace mien::pipeline
