#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "pipeline/study/results/figures/interval_chart.h"
#include "pipeline/study/results/figures/result_figures.h"

namespace mien::pipeline {

namespace {

std::string note_of(const StimulusWorth& one) {
  return std::isnan(one.worth) ? record_text(one) + ": no finite worth" : "";
}

/// A line without an estimate that begins a group of comparable worths.
IntervalLine group_heading(const std::string& text) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  return {.name = text, .note = "", .value = none, .ends = {none, none}};
}

IntervalChart worth_chart(const AnswerSet& answer_set, const PairWorth& worth) {
  IntervalChart chart;
  const bool are_stimuli = answer_set.factorial.factors.empty();
  chart.axis = are_stimuli ? "Log-worth (0: mean of these stimuli)"
                           : "Log-worth (0: mean of these conditions)";
  chart.title = (are_stimuli ? "Worth of the stimuli: " : "Worth of the conditions: ") +
                pair_question(answer_set, worth.item);
  chart.words =
      std::string(!worth.has_intervals() ? "Without intervals; "
                  : worth.is_by_participants
                      ? "With 95 % intervals (participants resampled); "
                      : "With 95 % intervals (profile likelihood, answers independent); ") +
      "a difference of 1: odds of 2.7 to 1 of being chosen";
  std::vector<const StimulusWorth*> sorted;
  int groups = 0;
  for (const StimulusWorth& one : worth.stimuli) {
    sorted.push_back(&one);
    const auto same = [&](const StimulusWorth* other) {
      return !std::isnan(other->worth) && other->group == one.group && other != &one;
    };
    groups += !std::isnan(one.worth) && std::ranges::none_of(sorted, same) ? 1 : 0;
  }
  // Highest worth first; those without worth by their record: above, below.
  const auto rank = [](const StimulusWorth* one) {
    constexpr double beyond = 1e9;
    if (!std::isnan(one->worth)) return one->worth - 1e3 * one->group;
    return one->record == WinRecord::always_won ? beyond : -beyond;
  };
  std::ranges::stable_sort(sorted, std::ranges::greater{}, rank);
  int group = 0;
  for (const StimulusWorth* one : sorted) {
    if (groups > 1 && !std::isnan(one->worth) && one->group != group) {
      group = one->group;
      chart.lines.push_back(group_heading(
          fmt::format("Group {}, whose worths can be compared with each other only", group)));
    }
    if (groups > 1 && std::isnan(one->worth) && group > 0) {
      group = 0;
      chart.lines.push_back(group_heading("Without a worth"));
    }
    chart.lines.push_back({one->name, note_of(*one), one->worth, worth.ends_of(*one)});
  }
  if (groups > 1) chart.axis = "Log-worth (0: mean of the group)";
  set_axis(chart, /*is_symmetric=*/true);
  return chart;
}

}  // namespace

void add_worth_figures(const Results& results, std::vector<ResultFigure>& figures) {
  for (const PairWorth& worth : results.worths)
    figures.push_back(
        {"worth-" + worth.item, "worth", "", "",
         worth.has_intervals()
             ? "Log-worths of Bradley and Terry’s model with 95 % intervals, highest first."
             : "Log-worths of Bradley and Terry’s model, highest first.",
         with_simulated_mark(interval_plot(worth_chart(results.answer_set, worth)),
                             results.answer_set.simulated)});
}

}  // namespace mien::pipeline
