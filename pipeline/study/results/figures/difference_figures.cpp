#include <cmath>
#include <map>
#include <tuple>

#include <fmt/format.h>

#include "pipeline/base/drawing/bar_chart.h"
#include "pipeline/study/results/figures/result_figures.h"

namespace mien::pipeline {

namespace {

BarChart differences_chart(const AnswerSet& answer_set, const std::string& title) {
  BarChart chart;
  chart.title = title;
  chart.axis = "Scale units towards the intended emotion";
  chart.whiskers = fmt::format("95 %; * p < {:g}, corrected", answer_set.alpha);
  chart.one_colour = true;
  chart.decimals = 2;
  chart.slot_width = 92.0;
  return chart;
}

/// `end` is +1 where positive differences are towards the emotion that former_name meant, else −1.
Bar difference_bar(const AnswerSet& answer_set, const std::string& name, int end,
                   const WithinParticipants& within, double p, const std::string& setting) {
  constexpr int fewest = 5;  // participants, so that intervals fit on the page
  const bool has_whisker = within.people >= fewest;
  const double low = has_whisker ? within.t.low(0.95) : std::nan("");
  const double high = has_whisker ? within.t.high(0.95) : std::nan("");
  const std::string count = fmt::format("n = {}", within.people);
  return {name + (p < answer_set.alpha ? " *" : ""),
          end * within.t.mean + 0.0,
          end > 0 ? low : -high,
          end > 0 ? high : -low,
          setting.empty() ? count : setting,
          created_colours.light,
          setting.empty() ? "" : count};
}

struct DifferenceFigure {
  ComparisonFamily family;
  std::string thesis;       ///< number of the corresponding figure; or empty
  std::string former_name;  ///< earlier name of its files; or empty
  std::string title;
  std::string caption;
};

void add_differences(const Results& results, const DifferenceFigure& drawn,
                     std::vector<ResultFigure>& figures) {
  const AnswerSet& answer_set = results.answer_set;
  BarChart chart = differences_chart(answer_set, drawn.title);
  for (const Comparison& c : results.comparisons) {
    if (c.family != drawn.family || c.intended_end == 0 || c.within.people < 2) continue;
    const ReportedStimulus& stimulus = answer_set.stimuli[c.stimulus];
    chart.bars.push_back(difference_bar(answer_set, stimulus.emotion, c.intended_end, c.within,
                                        c.paired_adjusted, stimulus.setting));
  }
  if (chart.bars.empty()) return;
  const std::string name(word_of(family_words, drawn.family));
  figures.push_back({"differences-" + name, "differences", drawn.thesis, drawn.former_name,
                     drawn.caption,
                     with_simulated_mark(bar_chart_plot(chart), answer_set.simulated)});
}

std::string level_of(const ReportedStimulus& stimulus, const std::string& factor) {
  for (const auto& [name, level] : stimulus.factors)
    if (name == factor) return level;
  return "";
}

/// A figure for each two levels of a factor; settings without that factor name the bars.
void add_levels(const Results& results, std::vector<ResultFigure>& figures) {
  const AnswerSet& answer_set = results.answer_set;
  std::map<std::tuple<std::string, std::string, std::string>, BarChart> charts;
  for (const Comparison& c : results.comparisons) {
    if (c.family != ComparisonFamily::between_levels || c.intended_end == 0 || c.within.people < 2)
      continue;
    const ReportedStimulus& stimulus = answer_set.stimuli[c.stimulus];
    const std::string one = level_of(stimulus, c.factor);
    const std::string other = level_of(answer_set.stimuli[*c.against], c.factor);
    const auto [chart, is_new] = charts.try_emplace({c.factor, one, other});
    if (is_new)
      chart->second =
          differences_chart(answer_set, fmt::format("{}: {} vs. {}", c.factor, one, other));
    std::string rest = stimulus.made;
    for (const auto& [factor, level] : stimulus.factors)
      if (factor != c.factor && factor != "made" && factor != "emotion" && factor != "example" &&
          factor != "clip")
        rest += ", " + level;
    chart->second.bars.push_back(difference_bar(answer_set, stimulus.emotion, c.intended_end,
                                                c.within, c.paired_adjusted, rest));
  }
  for (const auto& [levels, chart] : charts) {
    const auto& [factor, one, other] = levels;
    figures.push_back({fmt::format("differences-{}-{}-{}", factor, one, other), "levels", "", "",
                       "Within-participant differences, first minus second; positive towards the "
                       "intended emotion.",
                       with_simulated_mark(bar_chart_plot(chart), answer_set.simulated)});
  }
}

/// Over all settings, emotion by emotion.
void add_overall(const Results& results, ComparisonFamily family, const std::string& title,
                 std::vector<ResultFigure>& figures) {
  const AnswerSet& answer_set = results.answer_set;
  BarChart chart = differences_chart(answer_set, title + ", over all settings");
  for (const OverallComparison& c : results.overall) {
    if (c.family != family) continue;
    const std::string name = c.emotion.empty() ? "all" : c.emotion;
    chart.bars.push_back(difference_bar(answer_set, name, 1, c.within, c.paired_adjusted, ""));
  }
  if (chart.bars.empty()) return;
  figures.push_back(
      {"overall-" + std::string(word_of(family_words, family)), "differences", "", "",
       "Within-participant differences, averaged over the settings and emotions for which the "
       "participant rated both motions.",
       with_simulated_mark(bar_chart_plot(chart), answer_set.simulated)});
}

}  // namespace

void add_difference_figures(const Results& results, std::vector<ResultFigure>& figures) {
  const std::string within =
      "Within-participant differences; positive towards the intended emotion.";
  const DifferenceFigure drawn[] = {
      {ComparisonFamily::modified_acted, "", "figure-35-differences-modified-acted",
       "Modified vs. acted motions", within},
      {ComparisonFamily::modified_neutral, "35", "figure-36-differences-modified-neutral",
       "Modified vs. neutral motions", within},
      {ComparisonFamily::modified_best, "36", "",
       "Modified motions vs. the highest-rated unmodified video",
       within + " The highest-rated unmodified video was selected using the same answers, so its "
                "ratings are biased upwards."},
      {ComparisonFamily::acted_neutral, "", "", "Acted vs. neutral motions", within}};
  for (const DifferenceFigure& one : drawn) {
    add_overall(results, one.family, one.title, figures);
    add_differences(results, one, figures);
  }
  add_levels(results, figures);
}

}  // namespace mien::pipeline
