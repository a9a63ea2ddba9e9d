#include "pipeline/base/adaptive/staircase.h"

#include <algorithm>
#include <cmath>

namespace mien::pipeline {

namespace {

std::size_t nearest_place(const std::vector<double>& grid, double level) {
  const auto distance = [&](double other) { return std::abs(other - level); };
  return static_cast<std::size_t>(std::ranges::min_element(grid, {}, distance) - grid.begin());
}

/// Where a staircase is: a level, or a place on the grid.
class Position {
 public:
  explicit Position(const StaircaseSettings& settings) : settings_(settings) {
    value_ = settings.grid.empty()
                 ? std::clamp(settings.start, settings.lowest, settings.highest)
                 : static_cast<double>(nearest_place(settings.grid, settings.start));
  }

  double level() const {
    return settings_.grid.empty() ? value_ : settings_.grid[static_cast<std::size_t>(value_)];
  }

  void move(double by) {
    if (settings_.grid.empty()) {
      value_ = std::clamp(value_ + by, settings_.lowest, settings_.highest);
      return;
    }
    const double places = std::copysign(std::max(1.0, std::round(std::abs(by))), by);
    value_ = std::clamp(value_ + places, 0.0, static_cast<double>(settings_.grid.size() - 1));
  }

 private:
  const StaircaseSettings& settings_;
  double value_;
};

bool is_reached(std::size_t count, int limit) {
  return limit > 0 && count >= static_cast<std::size_t>(limit);
}

/// The probability that `successes` successes in a row come before `failures` failures in a row, if
/// each has the probability p (Feller 1968, section XIII.8).
double run_probability(double p, int successes, int failures) {
  const double q = 1.0 - p;
  const double own = std::pow(p, successes - 1);
  const double other = std::pow(q, failures - 1);
  return own * (1.0 - std::pow(q, failures)) / (own + other - own * other);
}

}  // namespace

StaircaseRun staircase_run(const StaircaseSettings& settings, const std::vector<bool>& answers) {
  StaircaseRun run;
  Position position(settings);
  int positive = 0;
  int negative = 0;
  int direction = 0;
  for (const bool is_positive : answers) {
    run.levels.push_back(position.level());
    positive = is_positive ? positive + 1 : 0;
    negative = is_positive ? 0 : negative + 1;
    const bool falls = positive >= settings.positive_to_fall;
    if (!falls && negative < settings.negative_to_rise) continue;
    const int next = falls ? -1 : 1;
    if (direction == -next) run.reversals.push_back(run.levels.size() - 1);
    direction = next;
    positive = negative = 0;
    const bool is_early = run.reversals.size() < static_cast<std::size_t>(settings.early_reversals);
    const double step = falls ? -settings.step_down : settings.step_up;
    position.move(is_early ? settings.early_factor * step : step);
  }
  run.next_level = position.level();
  run.is_finished = is_reached(run.reversals.size(), settings.most_reversals) ||
                    is_reached(run.levels.size(), settings.most_trials);
  return run;
}

StaircaseEstimate staircase_estimate(const StaircaseRun& run, int left_out) {
  const std::size_t all = run.reversals.size();
  const std::size_t rest = all - std::min(all, static_cast<std::size_t>(left_out));
  const std::size_t used = rest - rest % 2;
  StaircaseEstimate estimate{std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::quiet_NaN(), static_cast<int>(used),
                             used == 0};
  if (estimate.has_too_few) return estimate;
  double sum = 0.0;
  for (std::size_t i = all - used; i < all; ++i) sum += run.levels[run.reversals[i]];
  estimate.level = sum / static_cast<double>(used);
  double squares = 0.0;
  for (std::size_t i = all - used; i < all; ++i)
    squares += std::pow(run.levels[run.reversals[i]] - estimate.level, 2.0);
  estimate.deviation = std::sqrt(squares / static_cast<double>(used - 1));
  return estimate;
}

double staircase_target(const StaircaseSettings& settings) {
  const double balance = settings.step_up / (settings.step_up + settings.step_down);
  double low = 0.0;
  double high = 1.0;
  constexpr int halvings = 60;
  for (int i = 0; i < halvings; ++i) {
    const double p = 0.5 * (low + high);
    (run_probability(p, settings.positive_to_fall, settings.negative_to_rise) < balance ? low
                                                                                        : high) = p;
  }
  return 0.5 * (low + high);
}

}  // namespace mien::pipeline
