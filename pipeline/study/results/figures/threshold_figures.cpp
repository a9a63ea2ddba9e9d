#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "pipeline/base/drawing/canvas.h"
#include "pipeline/base/drawing/palette.h"
#include "pipeline/study/results/figures/interval_chart.h"
#include "pipeline/study/results/figures/result_figures.h"

namespace mien::pipeline {

namespace {

constexpr double threshold_margin = 18.0;
constexpr double threshold_header = 58.0;
constexpr double threshold_gap = 44.0;         ///< between panels, with the labels of axes
constexpr double threshold_axis_width = 30.0;  ///< left of a panel
constexpr double threshold_width = 236.0;
constexpr double threshold_height = 128.0;
constexpr std::size_t threshold_columns = 2;
constexpr std::size_t most_threshold_panels = 12;  ///< of a figure

/// The levels that a figure shows, from the left edge to the right or from the bottom to the top.
struct LevelAxis {
  double low = 0.0;
  double high = 1.0;

  double share(double level) const { return (level - low) / (high - low); }
};

/// All levels that were shown, with some room at both ends.
LevelAxis level_axis(const ThresholdResults& results) {
  LevelAxis axis{INFINITY, -INFINITY};
  for (const ThresholdEstimate& one : results.estimates)
    for (const LevelCount& count : one.counts) {
      axis.low = std::min(axis.low, count.level);
      axis.high = std::max(axis.high, count.level);
    }
  const double room = 0.05 * std::max(axis.high - axis.low, 1e-6);
  return {axis.low - room, axis.high + room};
}

/// Ticks at multiples of 1, 2 or 5 times a power of ten, at most six.
std::vector<double> level_ticks(const LevelAxis& axis) {
  const double range = axis.high - axis.low;
  double step = std::pow(10.0, std::floor(std::log10(range / 6.0)));
  for (const double factor : {1.0, 2.0, 5.0, 10.0})
    if (range / (factor * step) <= 6.0) {
      step *= factor;
      break;
    }
  std::vector<double> ticks;
  for (double tick = std::ceil(axis.low / step); tick * step <= axis.high; ++tick)
    ticks.push_back(tick * step + 0.0);  // no −0
  return ticks;
}

/// What a panel shows: its name, a note at the right, and a function that draws into its area.
struct ThresholdPanel {
  std::string name, note;
  std::function<void(Canvas&, const Box&)> draw;
};

Plot threshold_plot(const std::string& title, const std::string& words,
                    const std::vector<ThresholdPanel>& panels) {
  const std::size_t columns = std::min(threshold_columns, panels.size());
  const std::size_t rows = (panels.size() + columns - 1) / columns;
  const double slot = threshold_axis_width + threshold_width + threshold_margin;
  const double width =
      threshold_margin + std::max(static_cast<double>(columns) * slot, 480.0) + threshold_margin;
  const double height = 2.0 * threshold_margin + threshold_header +
                        static_cast<double>(rows) * (threshold_height + threshold_gap);
  return {title, width, height, [=](Canvas& canvas) {
            canvas.text({threshold_margin, threshold_margin + 12.0}, title,
                        {.size = 12.0, .bold = true});
            canvas.text({threshold_margin, threshold_margin + 27.0}, words,
                        {.size = 8.5, .colour = quiet_ink});
            for (std::size_t i = 0; i < panels.size(); ++i) {
              const Box area = {
                  threshold_margin + threshold_axis_width + static_cast<double>(i % columns) * slot,
                  threshold_margin + threshold_header + 16.0 +
                      static_cast<double>(i / columns) * (threshold_height + threshold_gap),
                  threshold_width, threshold_height};
              canvas.text({area.x, area.y - 5.0}, panels[i].name,
                          {.size = 8.5, .bold = true, .max_width = area.width - 80.0});
              canvas.text({area.right(), area.y - 5.0}, panels[i].note,
                          {.size = 7.5, .colour = quiet_ink, .align = Align::right});
              panels[i].draw(canvas, area);
              canvas.outline(area, {.width = 0.6, .colour = quiet_ink});
            }
          }};
}

void draw_proportion_axes(Canvas& canvas, const Box& area, const LevelAxis& axis,
                          const std::string& factor) {
  for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    const double y = area.bottom() - share * area.height;
    canvas.line({area.x, y}, {area.right(), y}, {.width = 0.5, .colour = hairline});
    canvas.text({area.x - 4.0, y + 2.6}, fmt::format("{:.0f} %", 100.0 * share),
                {.size = 7.0, .colour = quiet_ink, .align = Align::right});
  }
  for (const double level : level_ticks(axis)) {
    const double x = area.x + axis.share(level) * area.width;
    canvas.line({x, area.bottom()}, {x, area.bottom() + 3.0}, {.width = 0.5, .colour = quiet_ink});
    canvas.text({x, area.bottom() + 11.0}, fmt::format("{:.4g}", level),
                {.size = 7.0, .colour = quiet_ink, .align = Align::centre});
  }
  canvas.text({area.x + 0.5 * area.width, area.bottom() + 21.0}, factor,
              {.size = 7.5, .colour = quiet_ink, .align = Align::centre});
}

/// The proportions by level, with areas in proportion to the numbers of answers, the fitted
/// function, and the threshold with its interval.
void draw_proportions(Canvas& canvas, const Box& area, const ThresholdEstimate& estimate,
                      const ThresholdDesign& design, const LevelAxis& axis) {
  const auto x = [&](double level) { return area.x + axis.share(level) * area.width; };
  const auto y = [&](double share) { return area.bottom() - share * area.height; };
  const IntervalEnds ends = estimate.threshold_ends;
  if (std::isfinite(ends.low) && std::isfinite(ends.high)) {
    const double left = std::clamp(x(ends.low), area.x, area.right());
    const double right = std::clamp(x(ends.high), area.x, area.right());
    canvas.fill(Box{left, area.y, right - left, area.height}, panel);
  }
  draw_proportion_axes(canvas, area, axis, design.factor);
  if (estimate.fit.problem == FitProblem::none) {
    constexpr int steps = 120;
    std::vector<Point> curve;
    for (int i = 0; i <= steps; ++i) {
      const double level = axis.low + (axis.high - axis.low) * i / steps;
      curve.push_back(
          {x(level), y(answer_probability(estimate.fit.function, design.sign * level).positive)});
    }
    canvas.polyline(curve, {.width = 1.5, .colour = created_colours.line});
  }
  if (std::isfinite(estimate.threshold) && estimate.threshold > axis.low &&
      estimate.threshold < axis.high)
    canvas.line({x(estimate.threshold), area.bottom()},
                {x(estimate.threshold), y(design.proportion)},
                {.width = 1.0, .colour = reference_colours.line, .dashed = true});
  int most = 1;
  for (const LevelCount& count : estimate.counts) most = std::max(most, count.trials);
  for (const LevelCount& count : estimate.counts)
    canvas.disc({x(count.level), y(1.0 * count.positive / count.trials)},
                1.2 + 2.8 * std::sqrt(1.0 * count.trials / most), ink);
}

ThresholdPanel proportions_panel(const Results& results, const ThresholdEstimate& estimate,
                                 const LevelAxis& axis) {
  const ThresholdDesign& design = *results.answer_set.thresholds;
  const std::string note = std::isfinite(estimate.threshold)
                               ? fmt::format("threshold {:.3g}", estimate.threshold)
                               : threshold_remark(estimate);
  return {estimate.person ? results.answer_set.people[*estimate.person] : "All answers", note,
          [=, &design](Canvas& canvas, const Box& area) {
            draw_proportions(canvas, area, estimate, design, axis);
          }};
}

/// The levels of a participant's tracks over the trials: filled if the answer was positive.
void draw_tracks(Canvas& canvas, const Box& area, const std::vector<TrackResult>& tracks,
                 const LevelAxis& axis, int trials) {
  const auto x = [&](int trial) {
    return area.x + area.width * (trial - 0.5) / std::max(trials, 1);
  };
  const auto y = [&](double level) { return area.bottom() - axis.share(level) * area.height; };
  for (const double level : level_ticks(axis)) {
    canvas.line({area.x, y(level)}, {area.right(), y(level)}, {.width = 0.5, .colour = hairline});
    canvas.text({area.x - 4.0, y(level) + 2.6}, fmt::format("{:.4g}", level),
                {.size = 7.0, .colour = quiet_ink, .align = Align::right});
  }
  canvas.text({area.x, area.bottom() + 11.0}, "1", {.size = 7.0, .colour = quiet_ink});
  canvas.text({area.right(), area.bottom() + 11.0}, fmt::format("trial {}", trials),
              {.size = 7.0, .colour = quiet_ink, .align = Align::right});
  constexpr std::array track_colours = {created_colours.line, reference_colours.line,
                                        target_colours.line, ink};
  for (const TrackResult& track : tracks) {
    const Colour& colour =
        track_colours[static_cast<std::size_t>(track.track - 1) % track_colours.size()];
    std::vector<Point> line;
    for (const TrackPoint& point : track.points) line.push_back({x(point.trial), y(point.level)});
    if (line.size() > 1) canvas.polyline(line, {.width = 0.8, .colour = colour});
    for (const TrackPoint& point : track.points) {
      const Point at = {x(point.trial), y(point.level)};
      canvas.disc(at, 2.0, point.is_positive ? colour : paper);
      canvas.ring(at, 2.0, {.width = 0.7, .colour = colour});
    }
  }
}

std::vector<ThresholdPanel> track_panels(const Results& results, const LevelAxis& axis) {
  std::vector<ThresholdPanel> panels;
  for (const ThresholdEstimate& one : results.thresholds.estimates) {
    if (!one.person) continue;
    std::vector<TrackResult> tracks;
    int trials = 0;
    for (const TrackResult& track : results.thresholds.tracks) {
      if (track.person != *one.person) continue;
      tracks.push_back(track);
      trials = std::max(trials, track.points.back().trial);
    }
    if (tracks.empty()) continue;
    panels.push_back({results.answer_set.people[*one.person],
                      fmt::format("{} track{}", tracks.size(), tracks.size() == 1 ? "" : "s"),
                      [=](Canvas& canvas, const Box& area) {
                        draw_tracks(canvas, area, tracks, axis, trials);
                      }});
  }
  return panels;
}

/// Adds figures of at most twelve panels each.
void add_threshold_panels(const Results& results, const std::vector<ThresholdPanel>& panels,
                          const std::string& name, const std::string& title,
                          const std::string& words, const std::string& caption,
                          std::vector<ResultFigure>& figures) {
  for (std::size_t first = 0; first < panels.size(); first += most_threshold_panels) {
    const auto begin = panels.begin() + static_cast<std::ptrdiff_t>(first);
    const std::size_t count = std::min(most_threshold_panels, panels.size() - first);
    const std::string part =
        first == 0 ? "" : fmt::format("-{}", first / most_threshold_panels + 1);
    figures.push_back(
        {name + part, "thresholds", "", "", caption,
         with_simulated_mark(
             threshold_plot(title, words, {begin, begin + static_cast<std::ptrdiff_t>(count)}),
             results.answer_set.simulated)});
  }
}

/// The thresholds of the participants with their intervals.
void add_threshold_chart(const Results& results, std::vector<ResultFigure>& figures) {
  constexpr std::size_t most_lines = 60;
  IntervalChart chart;
  chart.title = "Thresholds by participant";
  chart.words = "Thresholds with 95 % intervals (bootstrap, answers independent)";
  chart.axis = results.answer_set.thresholds->factor;
  for (const ThresholdEstimate& one : results.thresholds.estimates)
    if (one.person)
      chart.lines.push_back({results.answer_set.people[*one.person],
                             threshold_remark(one),
                             one.threshold,
                             {one.threshold_ends.low, one.threshold_ends.high}});
  if (chart.lines.size() < 2 || chart.lines.size() > most_lines) return;
  set_axis(chart, /*is_symmetric=*/false);
  figures.push_back({"thresholds-by-participant", "thresholds", "", "",
                     "Thresholds of the participants with 95 % intervals.",
                     with_simulated_mark(interval_plot(chart), results.answer_set.simulated)});
}

}  // namespace

void add_threshold_figures(const Results& results, std::vector<ResultFigure>& figures) {
  const ThresholdResults& found = results.thresholds;
  if (found.estimates.empty()) return;
  const LevelAxis axis = level_axis(found);
  std::vector<ThresholdPanel> panels;
  for (const ThresholdEstimate& one : found.estimates)
    panels.push_back(proportions_panel(results, one, axis));
  const std::string share =
      fmt::format("{:.3g} %", 100.0 * results.answer_set.thresholds->proportion);
  add_threshold_panels(
      results, panels, "proportions-by-level", "Positive answers by level",
      "Areas of dots: numbers of answers. Grey: 95 % interval of the threshold at " + share + ".",
      "Proportions of positive answers (right, yes or different) by level, with the fitted "
      "psychometric function and the threshold at " +
          share + " of positive answers.",
      figures);
  add_threshold_panels(
      results, track_panels(results, axis), "tracks", "Levels over the trials",
      "Filled: positive answers. Each track has a colour.",
      "Levels of the tracks over the trials of each participant; filled dots are positive "
      "answers.",
      figures);
  add_threshold_chart(results, figures);
}

}  // namespace mien::pipeline
