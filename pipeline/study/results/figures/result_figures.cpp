#include "pipeline/study/results/figures/result_figures.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "pipeline/base/drawing/bar_chart.h"
#include "pipeline/study/results/comparisons.h"
#include "pipeline/study/results/figures/heat_map.h"
#include "pipeline/study/results/figures/rating_grid.h"

namespace mien::pipeline {

namespace {

constexpr std::size_t max_columns = 8;  // scales beside each other

RatingPanel panel_of(const AnswerSet& answer_set, const RatingSummary& summary) {
  const Scale& scale = answer_set.scales[summary.scale];
  return {.counts = summary.counts,
          .mean = share_of(scale, summary.mean),
          .low = share_of(scale, summary.low),
          .high = share_of(scale, summary.high),
          .is_marked = end_sign(scale, answer_set.stimuli[summary.stimulus].emotion) != 0};
}

/// The rows of these stimuli on the scales from `first` up to `end`.
RatingGrid grid_of(const Results& results, const std::vector<std::size_t>& stimuli,
                   std::size_t first, std::size_t end) {
  const AnswerSet& answer_set = results.answer_set;
  RatingGrid grid;
  grid.simulated = answer_set.simulated;
  for (std::size_t s = first; s < end; ++s)
    grid.columns.push_back({answer_set.scales[s].low, answer_set.scales[s].high});
  for (const std::size_t stimulus : stimuli) {
    RatingRow row;
    row.name = answer_set.stimuli[stimulus].id;
    row.panels.resize(end - first);
    int answers = 0;
    for (const RatingSummary& summary : results.summaries) {
      if (summary.stimulus != stimulus || summary.scale < first || summary.scale >= end) continue;
      row.panels[summary.scale - first] = panel_of(answer_set, summary);
      answers = std::max(answers, summary.answers);
    }
    if (answers == 0) continue;
    row.note = fmt::format("n = {}", answers);
    grid.rows.push_back(std::move(row));
  }
  return grid;
}

bool has_marked_panels(const RatingGrid& grid) {
  return std::ranges::any_of(grid.rows, [](const RatingRow& row) {
    return std::ranges::any_of(row.panels, [](const auto& panel) { return panel.is_marked; });
  });
}

using DrawGrid = Plot (*)(const RatingGrid&);

void add_grids(const Results& results, const std::vector<std::size_t>& stimuli,
               const ResultFigure& figure, const std::string& title, DrawGrid draw,
               std::vector<ResultFigure>& figures) {
  const std::size_t scales = results.answer_set.scales.size();
  for (std::size_t first = 0; first < scales; first += max_columns) {
    const std::size_t end = std::min(scales, first + max_columns);
    RatingGrid grid = grid_of(results, stimuli, first, end);
    if (grid.rows.empty()) return;
    ResultFigure part = figure;
    if (has_marked_panels(grid)) part.caption += " Yellow: intended emotion's scale.";
    grid.title = title;
    grid.words = part.caption;
    if (first > 0) {
      part.name += fmt::format("-{}", first / max_columns + 1);
      if (!part.former_name.empty())
        part.former_name += fmt::format("-{}", first / max_columns + 1);
    }
    part.plot = draw(grid);
    figures.push_back(std::move(part));
  }
}

/// The caption of histograms of all ratings, or of those " of the acted motions".
std::string spread_caption(const std::string& of = "") {
  return "Distribution of ratings" + of + "; the line marks the mean.";
}

/// The videos in which some end of a scale is seen most, each once.
std::vector<std::size_t> best_videos(const Results& results) {
  std::vector<std::size_t> videos;
  for (const BestSeen& best : best_seen(results.answer_set, results.comparisons))
    if (std::ranges::find(videos, best.comparison.stimulus) == videos.end())
      videos.push_back(best.comparison.stimulus);
  return videos;
}

/// Videos that differ in the level of a factor alone, one below the other.
void add_histograms_by_level(const Results& results, std::vector<ResultFigure>& figures) {
  std::vector<std::string> factors;
  for (const Comparison& c : results.comparisons)
    if (c.family == ComparisonFamily::between_levels &&
        std::ranges::find(factors, c.factor) == factors.end())
      factors.push_back(c.factor);
  for (const std::string& factor : factors) {
    std::vector<std::size_t> stimuli;
    const auto add = [&](std::size_t stimulus) {
      if (std::ranges::find(stimuli, stimulus) == stimuli.end()) stimuli.push_back(stimulus);
    };
    for (const Comparison& c : results.comparisons) {
      if (c.family != ComparisonFamily::between_levels || c.factor != factor) continue;
      add(c.stimulus);
      add(*c.against);
    }
    const ResultFigure figure{.name = "histograms-by-" + factor,
                              .section = "levels",
                              .thesis = factor == "actor" ? "39" : "",
                              .caption = spread_caption()};
    add_grids(results, stimuli, figure, "Ratings by " + factor, histogram_grid_plot, figures);
  }
}

/// The answers of either group of participants.
void add_histograms_of_groups(const Results& results, std::vector<ResultFigure>& figures) {
  std::vector<std::size_t> every(results.answer_set.stimuli.size());
  for (std::size_t i = 0; i < every.size(); ++i) every[i] = i;
  for (const ParticipantGroups& groups :
       participant_groups(results.demographics, results.answer_set)) {
    if (groups.question != "gender") continue;
    for (const bool first : {true, false}) {
      const std::vector<std::size_t>& people = first ? groups.people_one : groups.people_other;
      const std::string& answer = first ? groups.one : groups.other;
      Results own;
      own.answer_set = results.answer_set;
      std::erase_if(own.answer_set.ratings, [&](const AnalysedRating& rating) {
        return std::ranges::find(people, rating.person) == people.end();
      });
      own.summaries = summaries_of(own.answer_set);
      const ResultFigure figure{
          .name = first ? "histograms-by-gender" : "histograms-by-gender-other",
          .section = "groups",
          .thesis = first ? "42" : "43",
          .caption = spread_caption()};
      add_grids(own, every, figure, "Ratings by participants who answered: " + answer,
                histogram_grid_plot, figures);
    }
  }
}

void add_rating_figures(const Results& results, std::vector<ResultFigure>& figures) {
  const ResultFigure best{.name = "histograms-best-seen",
                          .section = "best",
                          .thesis = "32",
                          .caption = spread_caption(" of the highest-rated videos")};
  add_grids(results, best_videos(results), best, "Ratings of the highest-rated videos",
            histogram_grid_plot, figures);
  for (const StimulusGroup& group : stimulus_groups(results.answer_set)) {
    const ResultFigure figure{.name = "histograms-" + group.name,
                              .section = "histograms",
                              .former_name = group.former_name,
                              .caption = spread_caption(" of the " + group.words)};
    add_grids(results, group.stimuli, figure, "Ratings of the " + group.words, histogram_grid_plot,
              figures);
  }
  add_histograms_by_level(results, figures);
  add_histograms_of_groups(results, figures);
  std::vector<std::size_t> every(results.answer_set.stimuli.size());
  for (std::size_t i = 0; i < every.size(); ++i) every[i] = i;
  const bool has_intervals = std::ranges::any_of(
      results.summaries, [](const RatingSummary& summary) { return !std::isnan(summary.low); });
  const ResultFigure means{.name = "means",
                           .section = "means",
                           .thesis = "40",
                           .former_name = "figure-40-means",
                           .caption = has_intervals ? "Mean ratings with 95 % confidence intervals."
                                                    : "Mean ratings; one answer has no interval."};
  add_grids(results, every, means, "Means of all videos", mean_grid_plot, figures);
}

std::string percent_of(double share) { return fmt::format("{:.0f}", 100.0 * share); }

void add_confusion_figure(const Results& results, const Confusion& confusion,
                          const std::string& thesis, std::vector<ResultFigure>& figures) {
  HeatMap map;
  map.title = (confusion.by_points ? "Perceived emotions by ratings: "
                                   : "Perceived emotions by choices: ") +
              (confusion.of == "all" ? std::string("all videos") : confusion.of + " motions");
  map.words = confusion.by_points
                  ? "Percentage of each row's rating points; outlined: intended emotion"
                  : "Percentage of each row's choices; outlined: intended emotion";
  map.row_title = "intended";
  map.column_title = "perceived";
  map.column_names = confusion.columns;
  map.simulated = results.answer_set.simulated;
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
  const std::string name = "confusion-" + confusion.of + by;
  figures.push_back({name, "confusion", thesis,
                     thesis.empty() ? "" : fmt::format("figure-{}-{}", thesis, name),
                     map.words + ".", heat_map_plot(map)});
}

void add_recall_figure(const Results& results, const Confusion& confusion,
                       std::vector<ResultFigure>& figures) {
  BarChart chart;
  chart.title = (confusion.by_points ? "Recognition of emotions by ratings: "
                                     : "Recognition of emotions by choices: ") +
                (confusion.of == "all" ? std::string("all videos") : confusion.of + " motions");
  chart.axis = confusion.by_points ? "Proportion of points" : "Proportion of choices";
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
  figures.push_back({"recall-" + confusion.of + by, "confusion", "", "",
                     confusion.by_points
                         ? "Recall by rating points: the intended emotion's share of the points, "
                           "with 95 % Wilson intervals, compared with chance."
                         : "Recall by choices: the share of choices of the intended emotion, with "
                           "95 % Wilson intervals, compared with chance.",
                     with_simulated_mark(bar_chart_plot(chart), results.answer_set.simulated)});
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
  const std::vector<std::string> ends = ends_of(results.answer_set.scales);
  constexpr std::size_t max_ends = 24;  // more cannot be read
  if (results.correlations.empty() || ends.size() < 4 || ends.size() > max_ends) return;
  HeatMap map;
  map.title = "Correlations between scale ends";
  map.words =
      "Pearson's r over all judgements; bold: |r| > .5; outlined: |r| > .3; grey: the two ends of "
      "one scale";
  map.row_names = map.column_names = ends;
  map.simulated = results.answer_set.simulated;
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
  figures.push_back({"correlations", "correlations", "44", "figure-44-correlations",
                     map.words + ".", heat_map_plot(map)});
}

/// Levels of factors are any text; names of files are letters, digits, '.', '_' and '-', and no two
/// are the same.
void name_files(std::vector<ResultFigure>& figures) {
  std::set<std::string> taken;
  for (ResultFigure& figure : figures) {
    for (char& letter : figure.name)
      if (std::isalnum(static_cast<unsigned char>(letter)) == 0 && letter != '.' && letter != '_' &&
          letter != '-')
        letter = '-';
    const std::string name = figure.name;
    for (int number = 2; !taken.insert(figure.name).second; ++number)
      figure.name = fmt::format("{}-{}", name, number);
  }
}

}  // namespace

Plot with_simulated_mark(Plot plot, bool simulated) {
  if (!simulated) return plot;
  plot.draw = [draw = plot.draw, right = plot.width - 18.0](Canvas& canvas) {
    draw(canvas);
    draw_simulated_mark(canvas, {right, 49.0});
  };
  return plot;
}

std::vector<StimulusGroup> stimulus_groups(const AnswerSet& answer_set) {
  StimulusGroup acted{"acted", "acted motions", {}, "figure-32-histograms-acted"};
  StimulusGroup modified{"modified", "modified motions", {}, "figure-39-histograms-modified"};
  StimulusGroup neutral{"neutral", "neutral motions", {}, "figure-42-histograms-neutral"};
  StimulusGroup others{"others", "other motions", {}, "figure-43-histograms-others"};
  for (std::size_t i = 0; i < answer_set.stimuli.size(); ++i) {
    const ReportedStimulus& stimulus = answer_set.stimuli[i];
    StimulusGroup& group = stimulus.is_neutral()         ? neutral
                           : stimulus.made == "acted"    ? acted
                           : stimulus.made == "modified" ? modified
                                                         : others;
    group.stimuli.push_back(i);
  }
  if (acted.stimuli.empty() && modified.stimuli.empty()) {
    StimulusGroup all{"all", "videos", {}, "figure-32-histograms-all"};
    for (std::size_t i = 0; i < answer_set.stimuli.size(); ++i) all.stimuli.push_back(i);
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
  add_factor_figures(results, figures);
  add_confusion_figures(results, figures);
  add_correlation_figure(results, figures);
  add_pair_figures(results, figures);
  add_worth_figures(results, figures);
  add_grid_figures(results, figures);
  add_trace_figures(results, figures);
  add_detection_figures(results, figures);
  add_threshold_figures(results, figures);
  add_word_figures(results, figures);
  name_files(figures);
  return figures;
}

}  // namespace mien::pipeline
