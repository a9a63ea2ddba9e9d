#include "pipeline/results/figures/result_figures.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "pipeline/drawing/bar_chart.h"
#include "pipeline/results/figures/difference_figures.h"
#include "pipeline/results/figures/heat_map.h"
#include "pipeline/results/figures/pair_figures.h"
#include "pipeline/results/figures/rating_grid.h"
#include "pipeline/results/figures/word_figures.h"

namespace mien::pipeline {

namespace {

constexpr std::size_t most_columns = 8;  // scales beside each other

RatingPanel panel_of(const Gathered& gathered, const RatingSummary& summary) {
  const Scale& scale = gathered.scales[summary.scale];
  return {.counts = summary.counts,
          .mean = share_of(scale, summary.mean),
          .low = share_of(scale, summary.low),
          .high = share_of(scale, summary.high),
          .is_marked = end_of(scale, gathered.stimuli[summary.stimulus].emotion) != 0};
}

/// The rows of these stimuli on the scales from `first` up to `end`.
RatingGrid grid_of(const Results& results, const std::vector<std::size_t>& stimuli,
                   std::size_t first, std::size_t end) {
  const Gathered& gathered = results.gathered;
  RatingGrid grid;
  grid.simulated = gathered.simulated;
  for (std::size_t s = first; s < end; ++s)
    grid.columns.push_back({gathered.scales[s].low, gathered.scales[s].high});
  for (const std::size_t stimulus : stimuli) {
    RatingRow row;
    row.name = gathered.stimuli[stimulus].id;
    row.panels.resize(end - first);
    int answers = 0;
    for (const RatingSummary& summary : results.summaries) {
      if (summary.stimulus != stimulus || summary.scale < first || summary.scale >= end) continue;
      row.panels[summary.scale - first] = panel_of(gathered, summary);
      answers = std::max(answers, summary.answers);
    }
    if (answers == 0) continue;
    row.note = fmt::format("n = {}", answers);
    grid.rows.push_back(std::move(row));
  }
  return grid;
}

using DrawGrid = Plot (*)(const RatingGrid&);

void add_grids(const Results& results, const std::vector<std::size_t>& stimuli,
               const ResultFigure& figure, const std::string& title, DrawGrid draw,
               std::vector<ResultFigure>& figures) {
  const std::size_t scales = results.gathered.scales.size();
  for (std::size_t first = 0; first < scales; first += most_columns) {
    const std::size_t end = std::min(scales, first + most_columns);
    RatingGrid grid = grid_of(results, stimuli, first, end);
    if (grid.rows.empty()) return;
    grid.title = title;
    grid.words = figure.caption;
    ResultFigure part = figure;
    if (first > 0) part.name += fmt::format("-{}", first / most_columns + 1);
    part.plot = draw(grid);
    figures.push_back(std::move(part));
  }
}

void add_rating_figures(const Results& results, std::vector<ResultFigure>& figures) {
  for (const StimulusGroup& group : stimulus_groups(results.gathered)) {
    ResultFigure figure{name_after_thesis(group.histograms, "histograms-" + group.name),
                        "histograms",
                        group.histograms,
                        "How the answers are spread; the line is the mean. On a yellow ground: "
                        "the scale of the emotion that was meant.",
                        {}};
    add_grids(results, group.stimuli, figure, "Answers about the " + group.words,
              histogram_grid_plot, figures);
  }
  std::vector<std::size_t> every(results.gathered.stimuli.size());
  for (std::size_t i = 0; i < every.size(); ++i) every[i] = i;
  ResultFigure means{"figure-40-means",
                     "means",
                     "40",
                     "Mean answers with their 95 % intervals. On a yellow ground: the scale of the "
                     "emotion that was meant.",
                     {}};
  add_grids(results, every, means, "Means of all videos", mean_grid_plot, figures);
}

std::string percent_of(double share) { return fmt::format("{:.0f}", 100.0 * share); }

void add_confusion_figure(const Results& results, const Confusion& confusion,
                          const std::string& thesis, std::vector<ResultFigure>& figures) {
  HeatMap map;
  map.title = "What was seen in " +
              (confusion.of == "all" ? std::string("all videos") : confusion.of + " motions");
  map.words = confusion.by_points
                  ? "Shares of a row's points, in %; outlined: the emotion that was meant"
                  : "Shares of a row's choices, in %; outlined: the emotion that was meant";
  map.rows_are = "shown";
  map.columns_are = "seen";
  map.column_names = confusion.columns;
  map.simulated = results.gathered.simulated;
  for (const ConfusionRow& row : confusion.rows) {
    map.row_names.push_back(row.emotion);
    std::vector<HeatCell> cells;
    for (std::size_t i = 0; i < row.points.size(); ++i) {
      const double share = row.total > 0.0 ? row.points[i] / row.total : 0.0;
      const bool own = static_cast<int>(i) == row.own;
      cells.push_back({percent_of(share), share_colour(share), own, own});
    }
    map.cells.push_back(std::move(cells));
  }
  const std::string by = confusion.by_points ? "" : "-choices";
  figures.push_back({name_after_thesis(thesis, "confusion-" + confusion.of + by), "confusion",
                     thesis, map.words + ".", heat_map_plot(map)});
}

void add_recall_figure(const Results& results, const Confusion& confusion,
                       std::vector<ResultFigure>& figures) {
  BarChart chart;
  chart.title = "How well emotions were seen in " +
                (confusion.of == "all" ? std::string("all videos") : confusion.of + " motions");
  chart.axis = confusion.by_points ? "Share of points" : "Share of choices";
  chart.whiskers = "95 % interval (Wilson)";
  chart.line = confusion.chance;
  chart.line_name = fmt::format("chance {:.0f} %", 100.0 * confusion.chance);
  chart.percent = true;
  chart.one_colour = true;
  chart.decimals = 0;
  chart.slot_width = 64.0;
  for (const ConfusionRow& row : confusion.rows)
    if (row.own >= 0)
      chart.bars.push_back({row.emotion, row.recall, row.low, row.high,
                            fmt::format("n = {}", row.judged), created_colours.light});
  if (chart.bars.empty()) return;
  const std::string by = confusion.by_points ? "" : "-choices";
  figures.push_back({"recall-" + confusion.of + by, "confusion", "",
                     "Per-class recall with Wilson's intervals against chance.",
                     marked(bar_chart_plot(chart), results.gathered.simulated)});
}

void add_confusion_figures(const Results& results, std::vector<ResultFigure>& figures) {
  for (const Confusion& confusion : results.confusions) {
    const std::string thesis = confusion.of == "acted"      ? "33"
                               : confusion.of == "modified" ? "34"
                                                            : "";
    add_confusion_figure(results, confusion, confusion.by_points ? thesis : "", figures);
    add_recall_figure(results, confusion, figures);
  }
}

void add_correlation_figure(const Results& results, std::vector<ResultFigure>& figures) {
  const std::vector<std::string> ends = ends_of(results.gathered.scales);
  constexpr std::size_t most_ends = 24;  // more cannot be read
  if (results.correlations.empty() || ends.size() < 4 || ends.size() > most_ends) return;
  HeatMap map;
  map.title = "How the ends of the scales go together";
  map.words =
      "Pearson's r over all judgements; bold: |r| > .5; outlined: |r| > .3; grey: one scale";
  map.row_names = map.column_names = ends;
  map.simulated = results.gathered.simulated;
  map.cells.assign(ends.size(), std::vector<HeatCell>(ends.size(), HeatCell{"", hairline}));
  for (const EndCorrelation& pair : results.correlations) {
    const double r = pair.correlation.r;
    if (std::isnan(r)) continue;
    HeatCell cell{(r <= -0.005 ? "−" : "") + fmt::format("{:.2f}", std::abs(r)).substr(1),
                  pair.same_scale ? hairline : signed_colour(r),
                  !pair.same_scale && std::abs(r) > 0.3, !pair.same_scale && std::abs(r) > 0.5};
    if (std::abs(r) >= 0.995) cell.text = r < 0.0 ? "−1" : "1";
    map.cells[pair.one][pair.other] = map.cells[pair.other][pair.one] = cell;
  }
  figures.push_back(
      {"figure-44-correlations", "correlations", "44", map.words + ".", heat_map_plot(map)});
}

}  // namespace

std::string name_after_thesis(const std::string& thesis, const std::string& name) {
  return thesis.empty() ? name : "figure-" + thesis + "-" + name;
}

Plot marked(Plot plot, bool simulated) {
  if (!simulated) return plot;
  plot.draw = [draw = plot.draw, right = plot.width - 18.0](Canvas& canvas) {
    draw(canvas);
    draw_simulated_mark(canvas, {right, 49.0});
  };
  return plot;
}

std::vector<StimulusGroup> stimulus_groups(const Gathered& gathered) {
  StimulusGroup acted{"acted", "acted motions", {}, "32", "33", "31"};
  StimulusGroup modified{"modified", "modified motions", {}, "39", "34", "41"};
  StimulusGroup neutral{"neutral", "neutral motions", {}, "42", "", ""};
  StimulusGroup others{"others", "other motions", {}, "43", "", ""};
  for (std::size_t i = 0; i < gathered.stimuli.size(); ++i) {
    const ReportedStimulus& stimulus = gathered.stimuli[i];
    StimulusGroup& group = stimulus.is_neutral()         ? neutral
                           : stimulus.made == "acted"    ? acted
                           : stimulus.made == "modified" ? modified
                                                         : others;
    group.stimuli.push_back(i);
  }
  if (acted.stimuli.empty() && modified.stimuli.empty()) {
    StimulusGroup all{"all", "videos", {}, "32", "33", "31"};
    for (std::size_t i = 0; i < gathered.stimuli.size(); ++i) all.stimuli.push_back(i);
    return {all};
  }
  std::vector<StimulusGroup> groups;
  for (StimulusGroup* group : {&acted, &modified, &neutral, &others})
    if (!group->stimuli.empty()) groups.push_back(*group);
  return groups;
}

std::vector<ResultFigure> result_figures(const Results& results) {
  std::vector<ResultFigure> figures;
  add_rating_figures(results, figures);
  add_difference_figures(results, figures);
  add_confusion_figures(results, figures);
  add_correlation_figure(results, figures);
  add_pair_figures(results, figures);
  add_word_figures(results, figures);
  return figures;
}

}  // namespace mien::pipeline
