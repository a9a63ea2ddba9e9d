#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "pipeline/base/drawing/canvas.h"
#include "pipeline/base/drawing/palette.h"
#include "pipeline/study/results/figures/result_figures.h"

namespace mien::pipeline {

namespace {

constexpr double trace_margin = 18.0;
constexpr double trace_header = 46.0;
constexpr double trace_panel_width = 236.0;
constexpr double trace_panel_height = 108.0;
constexpr double trace_gap = 40.0;         ///< between panels, with the labels of axes
constexpr double trace_axis_width = 26.0;  ///< left of a panel
constexpr std::size_t trace_columns_of_panels = 2;
constexpr std::size_t most_trace_panels = 12;  ///< of a figure

/// The traces of one figure.
struct TraceChart {
  std::string title, words;
  struct Panel {
    std::string name;
    MeanTrace trace;
    std::vector<ShownMood> moods;  ///< lines where they change
  };
  std::vector<Panel> panels;
  double start = 50.0;  ///< of the marker
  double lead_s = 0.0;  ///< shaded: not part of the means of trials
};

/// A distance of ticks with at most six of them.
double tick_seconds(double longest) {
  for (const double step : {0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 60.0, 120.0})
    if (longest / step <= 6.0) return step;
  return 300.0;
}

void draw_trace_axes(Canvas& canvas, const Box& area, double longest) {
  for (const double value : {0.0, 25.0, 50.0, 75.0, 100.0}) {
    const double y = area.bottom() - value / 100.0 * area.height;
    canvas.line({area.x, y}, {area.right(), y}, {.width = 0.5, .colour = hairline});
    if (std::fmod(value, 50.0) == 0.0)
      canvas.text({area.x - 4.0, y + 2.6}, fmt::format("{:g}", value),
                  {.size = 7.0, .colour = quiet_ink, .align = Align::right});
  }
  const double step = tick_seconds(longest);
  for (double time = 0.0; time <= longest + 1e-9; time += step) {
    const double x = area.x + time / longest * area.width;
    canvas.line({x, area.bottom()}, {x, area.bottom() + 3.0}, {.width = 0.5, .colour = quiet_ink});
    canvas.text({x, area.bottom() + 11.0}, fmt::format("{:g} s", time),
                {.size = 7.0, .colour = quiet_ink, .align = Align::centre});
  }
}

/// Lines where the mood changes, each mood named at the top of its part of the film.
void draw_moods(Canvas& canvas, const std::vector<ShownMood>& moods, double longest,
                const Box& area) {
  const auto x = [&](double time) { return area.x + time / longest * area.width; };
  for (std::size_t i = 0; i < moods.size(); ++i) {
    if (moods[i].from_s >= longest) return;
    const double left = x(moods[i].from_s);
    const double right =
        i + 1 < moods.size() ? std::min(x(moods[i + 1].from_s), area.right()) : area.right();
    if (i > 0)
      canvas.line({left, area.y}, {left, area.bottom()},
                  {.width = 0.8, .colour = quiet_ink, .dashed = true});
    canvas.text({left + 3.0, area.y + 8.5}, moods[i].mood,
                {.size = 7.0, .colour = quiet_ink, .max_width = right - left - 5.0});
    if (i > 0)
      canvas.text({left + 3.0, area.y + 16.5}, fmt::format("from {:.1f} s", moods[i].from_s),
                  {.size = 6.5, .colour = quiet_ink, .max_width = right - left - 5.0});
  }
}

void draw_trace_panel(Canvas& canvas, const TraceChart& chart, const TraceChart::Panel& panel,
                      const Box& area) {
  const std::vector<TracePoint>& points = panel.trace.points;
  const double longest = std::max(points.back().time_s, 0.1);
  const auto x = [&](double time) { return area.x + time / longest * area.width; };
  const auto y = [&](double value) {
    return area.bottom() - std::clamp(value, 0.0, 100.0) / 100.0 * area.height;
  };
  canvas.text({area.x, area.y - 5.0}, panel.name,
              {.size = 8.5, .bold = true, .max_width = area.width - 50.0});
  canvas.text({area.right(), area.y - 5.0}, fmt::format("n = {}", points.front().people),
              {.size = 7.5, .colour = quiet_ink, .align = Align::right});
  canvas.fill(Box{area.x, area.y, std::min(x(chart.lead_s), area.right()) - area.x, area.height},
              mien::pipeline::panel);
  draw_trace_axes(canvas, area, longest);
  std::vector<Point> band, line;
  for (const TracePoint& point : points) line.push_back({x(point.time_s), y(point.mean)});
  if (std::isfinite(points.front().ends.low)) {
    for (const TracePoint& point : points) band.push_back({x(point.time_s), y(point.ends.high)});
    for (auto point = points.rbegin(); point != points.rend(); ++point)
      band.push_back({x(point->time_s), y(point->ends.low)});
    canvas.fill(band, created_colours.light, 0.4);
  }
  canvas.polyline(line, {.width = 1.5, .colour = created_colours.line});
  draw_moods(canvas, panel.moods, longest, area);
  canvas.outline(area, {.width = 0.6, .colour = quiet_ink});
}

Plot trace_plot(const TraceChart& chart) {
  const std::size_t columns = std::min(trace_columns_of_panels, chart.panels.size());
  const std::size_t rows = (chart.panels.size() + columns - 1) / columns;
  const double slot_width = trace_axis_width + trace_panel_width;
  const double slot_height = trace_panel_height + trace_gap;
  const double width = 2.0 * trace_margin +
                       std::max(static_cast<double>(columns) * (slot_width + trace_margin), 460.0);
  const double height = 2.0 * trace_margin + trace_header + static_cast<double>(rows) * slot_height;
  return {
      chart.title, width, height, [=](Canvas& canvas) {
        canvas.text({trace_margin, trace_margin + 12.0}, chart.title, {.size = 12.0, .bold = true});
        canvas.text({trace_margin, trace_margin + 27.0}, chart.words,
                    {.size = 8.5, .colour = quiet_ink});
        for (std::size_t i = 0; i < chart.panels.size(); ++i) {
          const auto column = static_cast<double>(i % columns);
          const auto row = static_cast<double>(i / columns);
          draw_trace_panel(canvas, chart, chart.panels[i],
                           {trace_margin + trace_axis_width + column * (slot_width + trace_margin),
                            trace_margin + trace_header + 16.0 + row * slot_height,
                            trace_panel_width, trace_panel_height});
        }
      }};
}

}  // namespace

void add_trace_figures(const Results& results, std::vector<ResultFigure>& figures) {
  const AnswerSet& answer_set = results.answer_set;
  for (std::size_t s = 0; s < answer_set.scales.size(); ++s) {
    const Scale& scale = answer_set.scales[s];
    TraceChart chart{
        .title = fmt::format("Ratings over time: {} – {}", scale.low, scale.high),
        .words = fmt::format("0: {}, 100: {}. Mean over participants with 95 % intervals of each "
                             "time alone.",
                             scale.low, scale.high),
        .panels = {},
        .lead_s = answer_set.trace_lead_s};
    int number = 1;
    const auto draw = [&] {
      const std::string part = number == 1 ? "" : fmt::format("-{}", number);
      ++number;
      figures.push_back(
          {"traces-" + scale.id + part, "traces", "", "",
           fmt::format(
               "Mean of the markers over participants, with pointwise 95 % intervals "
               "(Student); the means of trials leave out what is shaded.{}",
               std::ranges::any_of(chart.panels, [](auto& one) { return !one.moods.empty(); })
                   ? " Dashed lines: where the mood of the walk begins to change."
                   : ""),
           with_simulated_mark(trace_plot(chart), answer_set.simulated)});
      chart.panels.clear();
    };
    for (const MeanTrace& mean : results.traces.means) {
      if (mean.scale != s || mean.points.empty()) continue;
      if (chart.panels.size() == most_trace_panels) draw();
      const ReportedStimulus& stimulus = answer_set.stimuli[mean.stimulus];
      chart.panels.push_back({stimulus.id, mean, stimulus.moods});
    }
    if (!chart.panels.empty()) draw();
  }
}

}  // namespace mien::pipeline
