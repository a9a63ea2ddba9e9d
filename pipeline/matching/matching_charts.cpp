#include "pipeline/matching/matching_charts.h"

#include <limits>

#include <fmt/format.h>

namespace mien::pipeline {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

std::vector<Bar> mean_bars(const MatchingEvaluation& evaluation, MatchingMeasure measure) {
  std::vector<Bar> bars;
  for (const MatchingMean& m : evaluation.means) {
    if (m.measure != measure || !m.target.empty()) continue;
    bars.push_back({m.interface, m.mean, m.mean - m.sd, m.mean + m.sd, fmt::format("n = {}", m.n)});
  }
  return bars;
}

std::vector<Bar> share_bars(const MatchingEvaluation& evaluation, int MatchingShare::*part,
                            int MatchingShare::*all) {
  std::vector<Bar> bars;
  for (const MatchingShare& s : evaluation.shares) {
    const double share = s.*all > 0 ? s.*part / static_cast<double>(s.*all) : 0.0;
    bars.push_back({s.interface, share, none, none, fmt::format("{} of {}", s.*part, s.*all)});
  }
  return bars;
}

}  // namespace

BarChart first_guess_chart(const MatchingEvaluation& evaluation, bool simulated) {
  BarChart chart;
  chart.title = "Distance of the first guess";
  chart.axis = "D, metres";
  chart.whiskers = "± 1 SD over participants";
  chart.bars = mean_bars(evaluation, MatchingMeasure::first_guess_d);
  chart.line = evaluation.threshold_m;
  chart.line_name = fmt::format("threshold {:g} m", evaluation.threshold_m);
  chart.decimals = 3;
  chart.simulated = simulated;
  return chart;
}

BarChart first_guess_success_chart(const MatchingEvaluation& evaluation, bool simulated) {
  BarChart chart;
  chart.title = "First guesses that matched";
  chart.axis = fmt::format("share of guesses with D < {:g} m", evaluation.threshold_m);
  chart.bars = share_bars(evaluation, &MatchingShare::near_guesses, &MatchingShare::guesses);
  chart.percent = true;
  chart.simulated = simulated;
  return chart;
}

BarChart time_chart(const MatchingEvaluation& evaluation, bool simulated) {
  BarChart chart;
  chart.title = "Time until the match";
  chart.axis = "seconds";
  chart.whiskers = "± 1 SD over participants";
  chart.bars = mean_bars(evaluation, MatchingMeasure::time_s);
  chart.simulated = simulated;
  return chart;
}

BarChart time_saved_chart(const MatchingEvaluation& evaluation, bool simulated) {
  BarChart chart;
  chart.title = "Time saved by the second interface";
  chart.axis = "seconds";
  chart.whiskers = "90 % interval of the mean";
  chart.one_colour = true;
  for (const MatchingComparison& c : evaluation.comparisons) {
    if (c.measure != MatchingMeasure::time_s) continue;
    chart.bars.push_back({c.first + " → " + c.second, c.difference.mean, c.difference.low(0.9),
                          c.difference.high(0.9), fmt::format("n = {}", c.exact.pairs)});
  }
  chart.simulated = simulated;
  return chart;
}

BarChart failures_chart(const MatchingEvaluation& evaluation, bool simulated) {
  BarChart chart;
  chart.title = "Trials without a match";
  chart.axis = "share of trials that reached the time limit";
  chart.bars = share_bars(evaluation, &MatchingShare::failures, &MatchingShare::trials);
  chart.percent = true;
  chart.simulated = simulated;
  return chart;
}

}  // namespace mien::pipeline
