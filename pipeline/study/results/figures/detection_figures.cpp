#include <cmath>

#include <fmt/format.h>

#include "pipeline/study/results/figures/interval_chart.h"
#include "pipeline/study/results/figures/result_figures.h"

namespace mien::pipeline {

namespace {

/// The sensitivities of which `is_shown`, without those that are unknown.
IntervalChart sensitivity_chart(const Results& results, const std::string& of, auto is_shown) {
  const AnswerSet& answer_set = results.answer_set;
  IntervalChart chart;
  chart.title = "Sensitivity by " + of;
  chart.words = "d′ with 95 % intervals (answers independent)";
  chart.axis = "d′ (0: no difference is perceived)";
  for (const DetectionResult& one : results.detection.rows) {
    if (!is_shown(one) || std::isnan(one.sensitivity.d)) continue;
    std::string name =
        one.person ? answer_set.people[*one.person] : answer_set.stimuli[*one.stimulus].id;
    if (one.other) name += " – " + answer_set.stimuli[*one.other].id;
    chart.lines.push_back({name, "", one.sensitivity.d, one.sensitivity.d_ends});
  }
  set_axis(chart, /*is_symmetric=*/false);
  return chart;
}

}  // namespace

void add_detection_figures(const Results& results, std::vector<ResultFigure>& figures) {
  if (results.detection.rows.empty()) return;
  constexpr std::size_t most_lines = 60;
  const auto add = [&](const std::string& of, auto is_shown) {
    const IntervalChart chart = sensitivity_chart(results, of, is_shown);
    if (chart.lines.empty() || chart.lines.size() > most_lines) return;
    figures.push_back({"sensitivity-by-" + of, "sensitivity", "", "",
                       fmt::format("d′ with 95 % intervals, by {}.", of),
                       with_simulated_mark(interval_plot(chart), results.answer_set.simulated)});
  };
  add(results.answer_set.form->stimuli > 1 ? "pair" : "stimulus",
      [](const DetectionResult& one) { return one.stimulus.has_value(); });
  add("participant", [](const DetectionResult& one) { return one.person.has_value(); });
}

}  // namespace mien::pipeline
