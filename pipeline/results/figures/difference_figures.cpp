#include "pipeline/results/figures/difference_figures.h"

#include <cmath>

#include <fmt/format.h>

#include "pipeline/drawing/bar_chart.h"

namespace mien::pipeline {

namespace {

BarChart differences_chart(const Gathered& gathered, const std::string& title) {
  BarChart chart;
  chart.title = title;
  chart.axis = "Scale points towards the emotion that was meant";
  chart.whiskers = fmt::format("95 %; * p < {:g}, corrected", gathered.alpha);
  chart.one_colour = true;
  chart.decimals = 2;
  chart.slot_width = 92.0;
  return chart;
}

/// `end` is +1 where positive differences are towards the emotion that was meant, else −1.
Bar difference_bar(const Gathered& gathered, const std::string& name, int end,
                   const WithinPersons& within, double p, const std::string& setting) {
  constexpr int fewest = 5;  // whose interval does not run off the page
  const bool has_whisker = within.people >= fewest;
  const double low = has_whisker ? within.t.low(0.95) : std::nan("");
  const double high = has_whisker ? within.t.high(0.95) : std::nan("");
  const std::string count = fmt::format("n = {}", within.people);
  return {name + (p < gathered.alpha ? " *" : ""),
          end * within.t.mean + 0.0,
          end > 0 ? low : -high,
          end > 0 ? high : -low,
          setting.empty() ? count : setting,
          created_colours.light,
          setting.empty() ? "" : count};
}

void add_differences(const Results& results, ComparisonFamily family, const std::string& thesis,
                     const std::string& title, std::vector<ResultFigure>& figures) {
  const Gathered& gathered = results.gathered;
  BarChart chart = differences_chart(gathered, title);
  for (const Comparison& c : results.comparisons) {
    if (c.family != family || c.own_end == 0 || c.within.people < 2) continue;
    const ReportedStimulus& stimulus = gathered.stimuli[c.stimulus];
    chart.bars.push_back(difference_bar(gathered, stimulus.emotion, c.own_end, c.within,
                                        c.paired_adjusted, stimulus.setting));
  }
  if (chart.bars.empty()) return;
  const std::string name(word_of(family_words, family));
  figures.push_back({name_after_thesis(thesis, "differences-" + name), "differences", thesis,
                     "Within persons, towards the emotion that was meant.",
                     marked(bar_chart_plot(chart), gathered.simulated)});
}

/// Over all settings, emotion by emotion.
void add_overall(const Results& results, ComparisonFamily family, const std::string& title,
                 std::vector<ResultFigure>& figures) {
  const Gathered& gathered = results.gathered;
  BarChart chart = differences_chart(gathered, title + ", over all settings");
  for (const OverallComparison& c : results.overall) {
    if (c.family != family) continue;
    const std::string name = c.emotion.empty() ? "all" : c.emotion;
    chart.bars.push_back(difference_bar(gathered, name, 1, c.within, c.paired_adjusted, ""));
  }
  if (chart.bars.empty()) return;
  figures.push_back({"overall-" + std::string(word_of(family_words, family)), "differences", "",
                     "Of each person the mean over all settings of either side.",
                     marked(bar_chart_plot(chart), gathered.simulated)});
}

}  // namespace

void add_difference_figures(const Results& results, std::vector<ResultFigure>& figures) {
  const auto differences = [&](ComparisonFamily family, const std::string& thesis,
                               const std::string& title) {
    add_overall(results, family, title, figures);
    add_differences(results, family, thesis, title, figures);
  };
  differences(ComparisonFamily::modified_acted, "35", "Modified motions against acted ones");
  differences(ComparisonFamily::modified_neutral, "36", "Modified motions against neutral ones");
  differences(ComparisonFamily::acted_neutral, "", "Acted motions against neutral ones");
}

}  // namespace mien::pipeline
