#include <algorithm>
#include <functional>

#include <fmt/format.h>

#include "pipeline/study/results/figures/interval_chart.h"
#include "pipeline/study/results/figures/result_figures.h"

namespace mien::pipeline {

void add_grid_figures(const Results& results, std::vector<ResultFigure>& figures) {
  const GridResults& grid = results.grid;
  if (grid.means.empty()) return;
  const Scale& scale = results.answer_set.scales.front();
  std::vector<GridMean> means = grid.means;
  std::ranges::stable_sort(means, std::ranges::greater{}, &GridMean::mean);
  IntervalChart chart{.title = fmt::format("Ratings: {} – {}", scale.low, scale.high),
                      .words = "Means by condition with 95 % intervals (over participants)",
                      .axis = fmt::format("0: {}, 100: {}", scale.low, scale.high),
                      .lines = {},
                      .low = 0.0,
                      .high = 100.0,
                      .step = 20.0};
  for (const GridMean& one : means) {
    const GridCondition& condition = grid.conditions[one.condition];
    chart.lines.push_back({condition.name,
                           condition.role == "reference" ? "hidden reference" : condition.role,
                           one.mean, one.ends});
  }
  figures.push_back({"grid-" + scale.id, "grid", "", "",
                     "Means of the conditions with 95 % intervals, highest first.",
                     with_simulated_mark(interval_plot(chart), results.answer_set.simulated)});
}

}  // namespace mien::pipeline
