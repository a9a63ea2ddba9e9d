#include <algorithm>

#include <fmt/format.h>

#include "pipeline/base/drawing/bar_chart.h"
#include "pipeline/study/results/figures/result_figures.h"

namespace mien::pipeline {

namespace {

constexpr std::size_t most_pairs = 8;  // beside each other

/// Wide enough for the longest name.
double width_of_pair(const Gathered& gathered, const PreferenceCount& count) {
  constexpr double letter = 5.2;
  const std::size_t longest = std::max(gathered.stimuli[count.one].id.size() + 2,
                                       gathered.stimuli[count.other].id.size() + 5);
  return std::clamp(12.0 + letter * static_cast<double>(longest), 92.0, 200.0);
}

Bar pair_bar(const Gathered& gathered, const PreferenceCount& count) {
  const bool is_found = count.adjusted < gathered.alpha;
  return {gathered.stimuli[count.one].id + (is_found ? " *" : ""),
          1.0 * count.for_one / count.trials,
          count.low,
          count.high,
          fmt::format("not {}", gathered.stimuli[count.other].id),
          created_colours.light,
          fmt::format("n = {}", count.trials)};
}

BarChart pair_chart(const Gathered& gathered, const std::string& item) {
  BarChart chart;
  chart.title = "Preferred stimulus of each pair: " + asked_of_two(gathered, item);
  chart.axis = "Choices of the first-named stimulus";
  chart.whiskers = fmt::format("95 % Wilson interval; * p < {:g}, corrected", gathered.alpha);
  chart.line = 0.5;
  chart.line_name = "chance 50 %";
  chart.percent = true;
  chart.one_colour = true;
  chart.decimals = 0;
  return chart;
}

/// Adds the figures of the pairs of one question.
void add_pairs(const Gathered& gathered, const std::string& item,
               const std::vector<const PreferenceCount*>& pairs, std::size_t number,
               std::vector<ResultFigure>& figures) {
  BarChart chart = pair_chart(gathered, item);
  for (const PreferenceCount* pair : pairs) {
    chart.bars.push_back(pair_bar(gathered, *pair));
    chart.slot_width = std::max(chart.slot_width, width_of_pair(gathered, *pair));
  }
  const std::string name =
      "pairs-" + item + (number > 0 ? fmt::format("-{}", number + 1) : std::string());
  figures.push_back({name, "preferences", "", "",
                     "Proportion of choices with 95 % Wilson intervals; chance is one half.",
                     marked(bar_chart_plot(chart), gathered.simulated)});
}

}  // namespace

void add_pair_figures(const Results& results, std::vector<ResultFigure>& figures) {
  std::vector<std::string> items;
  for (const PreferenceCount& count : results.preferences)
    if (items.empty() || items.back() != count.item) items.push_back(count.item);
  for (const std::string& item : items) {
    std::vector<const PreferenceCount*> own;
    for (const PreferenceCount& count : results.preferences)
      if (count.item == item) own.push_back(&count);
    for (std::size_t first = 0; first < own.size(); first += most_pairs) {
      const auto begin = own.begin() + static_cast<std::ptrdiff_t>(first);
      const auto end =
          own.begin() + static_cast<std::ptrdiff_t>(std::min(own.size(), first + most_pairs));
      add_pairs(results.gathered, item, {begin, end}, first / most_pairs, figures);
    }
  }
}

}  // namespace mien::pipeline
