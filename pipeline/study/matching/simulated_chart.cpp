#include <limits>

#include <fmt/format.h>

#include "pipeline/base/drawing/bar_chart.h"
#include "pipeline/study/matching/simulated_evaluation.h"

namespace mien::pipeline {

namespace {

constexpr double no_whisker = std::numeric_limits<double>::quiet_NaN();

Colour colour_of(InterfaceKind kind) {
  switch (kind) {
    case InterfaceKind::adjectives:
      return target_colours.line;
    case InterfaceKind::features:
      return created_colours.line;
    case InterfaceKind::weights:
    case InterfaceKind::modifications:
      break;
  }
  return reference_colours.line;
}

std::string way_of(const InterfaceSummary& s) {
  return s.step > 0.0 ? fmt::format("step {:g}", s.step) : "guess";
}

BarChart simulated_bars(const std::string& title, const std::string& axis) {
  BarChart chart;
  chart.title = title;
  chart.axis = axis;
  chart.simulated = true;
  chart.slot_width = 60.0;
  return chart;
}

BarChart distance_chart(const std::vector<InterfaceSummary>& summaries, double threshold_m) {
  BarChart chart = simulated_bars("Nearest settings and first guesses", "D, metres");
  chart.whiskers = "±1 SD";
  chart.line = threshold_m;
  chart.line_name = fmt::format("{:g} m", threshold_m);
  chart.decimals = 3;
  for (const InterfaceSummary& s : summaries) {
    const double sd = s.count > 1 ? s.sd_first : no_whisker;
    chart.bars.push_back({way_of(s), s.mean_first, s.mean_first - sd, s.mean_first + sd,
                          name_of(s.kind), colour_of(s.kind)});
  }
  return chart;
}

BarChart share_chart(const std::vector<InterfaceSummary>& summaries, const std::string& title,
                     double InterfaceSummary::*share) {
  BarChart chart = simulated_bars(title, "proportion of simulated trials");
  chart.percent = true;
  chart.decimals = 0;
  for (const InterfaceSummary& s : summaries) {
    if (s.step > 0.0) continue;
    chart.bars.push_back({name_of(s.kind), s.*share, no_whisker, no_whisker,
                          fmt::format("n = {}", s.count), colour_of(s.kind)});
  }
  return chart;
}

}  // namespace

Plot simulated_chart(const std::vector<InterfaceSummary>& summaries, double threshold_m) {
  std::vector<BarChart> charts = {distance_chart(summaries, threshold_m)};
  for (BarChart& shares : std::vector{
           share_chart(summaries, "First guesses that match", &InterfaceSummary::first_success),
           share_chart(summaries, "Never matched", &InterfaceSummary::failure)})
    if (!shares.bars.empty()) charts.push_back(std::move(shares));
  return bar_charts_plot("Distance to the targets reached with each interface", charts,
                         "Simulated participants  模擬");
}

}  // namespace mien::pipeline
