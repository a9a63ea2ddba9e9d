#pragma once

#include <cstddef>
#include <limits>
#include <vector>

namespace mien::pipeline {

/// A staircase: the level falls after some positive answers in a row (correct, "yes", "different")
/// and rises after some negative ones, so that it comes to a known probability of positive answers
/// (transformed up–down methods, Levitt 1971; with steps of two sizes, Kaernbach 1991). Positive
/// answers must become more probable with the level: if they become less, change the sign of the
/// levels.
struct StaircaseSettings {
  double start = 0.0;
  int positive_to_fall = 2;  ///< ≥ 1
  int negative_to_rise = 1;  ///< ≥ 1
  /// Sizes of the steps, > 0, in units of the level; on a grid, numbers of places, rounded to whole
  /// ones, at least 1.
  double step_down = 1.0;
  double step_up = 1.0;
  /// Both steps are multiplied by `early_factor` until there were `early_reversals` reversals.
  double early_factor = 1.0;
  int early_reversals = 0;
  /// Levels stay between these.
  double lowest = -std::numeric_limits<double>::infinity();
  double highest = std::numeric_limits<double>::infinity();
  /// Levels in ascending order, if only some are possible. The staircase then starts at the one
  /// that is nearest to `start` (the lower of two), and `lowest` and `highest` are those of the
  /// grid.
  std::vector<double> grid = {};
  /// The staircase ends with so many reversals or trials, whichever is first; 0: without limit.
  int most_reversals = 0;
  int most_trials = 0;
};

/// A staircase after some answers. It follows from settings and answers alone.
struct StaircaseRun {
  std::vector<double> levels;  ///< of each answered trial
  /// Trials, from 0, whose answer changed the direction of the steps. A step that a bound shortens
  /// or prevents has a direction, too.
  std::vector<std::size_t> reversals;
  double next_level = 0.0;
  bool is_finished = false;
};

/// Replays the answers, true if positive.
StaircaseRun staircase_run(const StaircaseSettings& settings, const std::vector<bool>& answers);

/// The mean level of the last reversals.
struct StaircaseEstimate {
  double level;      ///< NaN with fewer than two reversals
  double deviation;  ///< standard deviation of these levels (n − 1 in the denominator); NaN as well
  int reversals = 0;         ///< their number, which is even
  bool has_too_few = false;  ///< fewer than two reversals remain
};

/// The estimate after the first reversals have been left out, and one more if the number of the
/// others is odd: as many peaks as valleys (Levitt 1971). If the steps have two sizes, it lies off
/// the target in the direction of the larger one: in simulations by 0.2 to 0.4 of the difference of
/// the sizes. A psychometric function fitted to all answers does not.
StaircaseEstimate staircase_estimate(const StaircaseRun& run, int left_out);

/// The probability of positive answers to which the staircase converges: that at which steps down
/// and up balance, P(down)·step_down = P(up)·step_up. It is ½^(1/n) for n positive answers to fall
/// and 1 negative to rise with equal steps (Levitt 1971), and step_up/(step_up + step_down) for 1
/// and 1 (Kaernbach 1991). That the level stays constant between two steps is an approximation that
/// holds for steps that are small compared with the width of the psychometric function
/// (García-Pérez 1998).
double staircase_target(const StaircaseSettings& settings);

}  // namespace mien::pipeline
