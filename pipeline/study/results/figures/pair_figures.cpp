#include <algorithm>

#include <fmt/format.h>

#include "pipeline/base/drawing/bar_chart.h"
#include "pipeline/study/results/figures/result_figures.h"

namespace mien::pipeline {

namespace {

constexpr std::size_t max_pairs = 8;  // beside each other

/// Wide enough for the longest name.
double width_of_pair(const AnswerSet& answer_set, const PreferenceCount& count) {
  constexpr double letter = 5.2;
  const std::size_t longest = std::max(answer_set.stimuli[count.one].id.size() + 2,
                                       answer_set.stimuli[count.other].id.size() + 5);
  return std::clamp(12.0 + letter * static_cast<double>(longest), 92.0, 200.0);
}

Bar pair_bar(const AnswerSet& answer_set, const PreferenceCount& count) {
  const bool is_significant = count.adjusted < answer_set.alpha;
  return {answer_set.stimuli[count.one].id + (is_significant ? " *" : ""),
          1.0 * count.for_one / count.trials,
          count.low,
          count.high,
          fmt::format("not {}", answer_set.stimuli[count.other].id),
          created_colours.light,
          fmt::format("n = {}", count.trials)};
}

BarChart pair_chart(const AnswerSet& answer_set, const std::string& item) {
  BarChart chart;
  chart.title = "Preferred stimulus of each pair: " + pair_question(answer_set, item);
  chart.axis = "Choices of the first-named stimulus";
  chart.whiskers = fmt::format("95 % Wilson interval; * p < {:g}, corrected", answer_set.alpha);
  chart.line = 0.5;
  chart.line_name = "chance 50 %";
  chart.percent = true;
  chart.one_colour = true;
  chart.decimals = 0;
  return chart;
}

/// Which of a question's pairs a figure has: first and last, from 1, and their number.
struct PairPart {
  std::size_t first = 1;
  std::size_t last = 1;
  std::size_t all = 1;

  bool is_all() const { return last - first + 1 == all; }
  /// "pairs 1 to 8 of 12"
  std::string text() const {
    return first == last ? fmt::format("pair {} of {}", first, all)
                         : fmt::format("pairs {} to {} of {}", first, last, all);
  }
};

std::string pair_caption(const AnswerSet& answer_set, const std::string& item,
                         const PairPart& part) {
  const bool has_ties =
      std::ranges::any_of(answer_set.preferences, [&](const AnalysedPreference& preference) {
        return preference.is_tie && preference.item == item;
      });
  return std::string("Proportion of choices with 95 % Wilson intervals; chance is one half.") +
         (part.is_all() ? "" : fmt::format(" This figure has {}.", part.text())) +
         (has_ties ? " Answers without a preference (ties) are left out." : "");
}

/// Adds the figures of the pairs of one question.
void add_pairs(const AnswerSet& answer_set, const std::string& item,
               const std::vector<const PreferenceCount*>& pairs, const PairPart& part,
               std::vector<ResultFigure>& figures) {
  BarChart chart = pair_chart(answer_set, item);
  if (!part.is_all()) chart.title += fmt::format(" ({})", part.text());
  for (const PreferenceCount* pair : pairs) {
    chart.bars.push_back(pair_bar(answer_set, *pair));
    chart.slot_width = std::max(chart.slot_width, width_of_pair(answer_set, *pair));
  }
  const std::string name =
      "pairs-" + item +
      (part.first > 1 ? fmt::format("-{}", (part.first - 1) / max_pairs + 1) : std::string());
  figures.push_back({name, "preferences", "", "", pair_caption(answer_set, item, part),
                     with_simulated_mark(bar_chart_plot(chart), answer_set.simulated)});
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
    for (std::size_t first = 0; first < own.size(); first += max_pairs) {
      const std::size_t last = std::min(own.size(), first + max_pairs);
      const auto begin = own.begin() + static_cast<std::ptrdiff_t>(first);
      const auto end = own.begin() + static_cast<std::ptrdiff_t>(last);
      add_pairs(results.answer_set, item, {begin, end}, {first + 1, last, own.size()}, figures);
    }
  }
}

}  // namespace mien::pipeline
