#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pipeline/base/drawing/canvas.h"
#include "pipeline/base/drawing/palette.h"
#include "pipeline/study/results/figures/result_figures.h"

namespace mien::pipeline {

namespace {

constexpr double factor_margin = 18.0;
constexpr double factor_header = 80.0;  // title, explanation, legend
constexpr double factor_axis_width = 34.0;
constexpr double factor_panel_height = 170.0;
constexpr double factor_panel_gap = 22.0;
constexpr double factor_names_height = 36.0;  // levels and the panel's name
constexpr std::size_t panels_in_row = 4;

/// Means of the levels of one factor, joined by a line.
struct LevelLine {
  std::vector<double> means, margins;  ///< a margin may be NaN
};

/// A combination of levels of the remaining factors, and a group.
struct CellPanel {
  std::string name;
  std::vector<LevelLine> lines;
};

struct CellChart {
  std::string title;
  std::string words;
  std::string axis;
  std::string across;               ///< factor along the horizontal axis
  std::vector<std::string> levels;  ///< of that factor
  std::string along;                ///< factor whose levels are lines; empty: a single line
  std::vector<std::string> lines;
  std::vector<CellPanel> panels;
  double low = 0.0, high = 1.0, step = 0.5;  ///< vertical axis
};

Colour line_colour(std::size_t line, std::size_t count) {
  const Colour few[] = {created_colours.line, reference_colours.line, target_colours.line};
  if (count <= std::size(few)) return few[line];
  return amount_colour(0.25 + 0.75 * static_cast<double>(line) / static_cast<double>(count - 1));
}

double panel_width_of(const CellChart& chart) {
  constexpr double least = 120.0;
  std::size_t longest = 0;
  for (const std::string& level : chart.levels) longest = std::max(longest, level.size());
  const double slot = std::clamp(10.0 + 4.4 * static_cast<double>(longest), 34.0, 80.0);
  return std::max(least, slot * static_cast<double>(chart.levels.size()));
}

std::string axis_number(double value, double step) {
  const int digits = step < 0.1 ? 2 : step < 1.0 ? 1 : 0;
  const std::string text = fmt::format("{:.{}f}", std::abs(value), digits);
  return (value < -0.5 * step ? "−" : "") + text;
}

void draw_panel_frame(Canvas& canvas, const CellChart& chart, const CellPanel& panel,
                      const Box& area) {
  const auto y = [&](double value) {
    return area.bottom() - (value - chart.low) / (chart.high - chart.low) * area.height;
  };
  for (double at = chart.low; at < chart.high + 0.5 * chart.step; at += chart.step) {
    const bool is_zero = std::abs(at) < 0.25 * chart.step;
    canvas.line({area.x, y(at)}, {area.right(), y(at)},
                {.width = is_zero ? 0.9 : 0.5, .colour = is_zero ? quiet_ink : hairline});
    canvas.text({area.x - 5.0, y(at) + 2.6}, axis_number(at, chart.step),
                {.size = 7.5, .colour = quiet_ink, .align = Align::right});
  }
  const double slot = area.width / static_cast<double>(chart.levels.size());
  for (std::size_t i = 0; i < chart.levels.size(); ++i)
    canvas.text({area.x + (static_cast<double>(i) + 0.5) * slot, area.bottom() + 12.0},
                chart.levels[i], {.size = 8.0, .align = Align::centre, .max_width = slot - 2.0});
  canvas.text({area.x + 0.5 * area.width, area.bottom() + 26.0},
              panel.name.empty() ? chart.across : panel.name,
              {.size = 8.0,
               .colour = quiet_ink,
               .bold = !panel.name.empty(),
               .align = Align::centre,
               .max_width = area.width});
}

void draw_lines(Canvas& canvas, const CellChart& chart, const CellPanel& panel, const Box& area) {
  const auto y = [&](double value) {
    return area.bottom() - (value - chart.low) / (chart.high - chart.low) * area.height;
  };
  const double slot = area.width / static_cast<double>(chart.levels.size());
  const double spread = std::min(7.0, 0.5 * slot / static_cast<double>(panel.lines.size()));
  for (std::size_t l = 0; l < panel.lines.size(); ++l) {
    const LevelLine& line = panel.lines[l];
    const Colour colour = line_colour(l, panel.lines.size());
    const double shift =
        spread * (static_cast<double>(l) - 0.5 * static_cast<double>(panel.lines.size() - 1));
    std::vector<Point> points;
    for (std::size_t i = 0; i < line.means.size(); ++i)
      points.push_back({area.x + (static_cast<double>(i) + 0.5) * slot + shift, y(line.means[i])});
    canvas.polyline(points, {.width = 1.1, .colour = colour, .dashed = l % 2 == 1});
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (std::isfinite(line.margins[i]))
        canvas.line({points[i].x, y(line.means[i] - line.margins[i])},
                    {points[i].x, y(line.means[i] + line.margins[i])},
                    {.width = 1.4, .colour = colour});
      canvas.disc(points[i], 2.6, colour);
    }
  }
}

void draw_legend(Canvas& canvas, const CellChart& chart, Point at) {
  if (chart.along.empty()) return;
  const TextStyle style = {.size = 8.0};
  canvas.text(at, chart.along + ":", {.size = 8.0, .colour = quiet_ink});
  at.x += canvas.text_width(chart.along + ":", style) + 8.0;
  for (std::size_t l = 0; l < chart.lines.size(); ++l) {
    const Colour colour = line_colour(l, chart.lines.size());
    canvas.line({at.x, at.y - 2.8}, {at.x + 16.0, at.y - 2.8},
                {.width = 1.1, .colour = colour, .dashed = l % 2 == 1});
    canvas.disc({at.x + 8.0, at.y - 2.8}, 2.6, colour);
    canvas.text({at.x + 20.0, at.y}, chart.lines[l], style);
    at.x += 32.0 + canvas.text_width(chart.lines[l], style);
  }
}

Plot cell_plot(const CellChart& chart) {
  constexpr double least_width = 420.0;
  constexpr double around = factor_axis_width + factor_panel_gap;
  const std::size_t columns = std::min(panels_in_row, chart.panels.size());
  const double fitting =
      (least_width - 2.0 * factor_margin) / static_cast<double>(columns) - around;
  const double panel = std::max(panel_width_of(chart), fitting);
  const std::size_t rows = (chart.panels.size() + columns - 1) / columns;
  const double step = panel + around;
  const double row_step = factor_panel_height + factor_names_height;
  const double width =
      std::max(least_width, 2.0 * factor_margin + step * static_cast<double>(columns));
  const double height = 2.0 * factor_margin + factor_header + row_step * static_cast<double>(rows);
  return {chart.title, width, height, [=](Canvas& canvas) {
            canvas.text({factor_margin, factor_margin + 12.0}, chart.title,
                        {.size = 12.0, .bold = true});
            canvas.text({factor_margin, factor_margin + 27.0}, chart.words,
                        {.size = 8.5, .colour = quiet_ink});
            draw_legend(canvas, chart, {factor_margin, factor_margin + 62.0});
            for (std::size_t i = 0; i < chart.panels.size(); ++i) {
              const Box area = {
                  factor_margin + factor_axis_width + step * static_cast<double>(i % columns),
                  factor_margin + factor_header + row_step * static_cast<double>(i / columns),
                  panel, factor_panel_height};
              draw_panel_frame(canvas, chart, chart.panels[i], area);
              draw_lines(canvas, chart, chart.panels[i], area);
            }
          }};
}

/// An axis with all intervals between two ticks.
void set_cell_axis(CellChart& chart) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const CellPanel& panel : chart.panels) {
    for (const LevelLine& line : panel.lines) {
      for (std::size_t i = 0; i < line.means.size(); ++i) {
        const double margin = std::isfinite(line.margins[i]) ? line.margins[i] : 0.0;
        low = std::min(low, line.means[i] - margin);
        high = std::max(high, line.means[i] + margin);
      }
    }
  }
  for (const double step : {0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0}) {
    chart.step = step;
    if ((high - low) / step <= 6.0) break;
  }
  chart.low = chart.step * std::floor(low / chart.step);
  chart.high = chart.step * std::ceil(high / chart.step);
  if (chart.high <= chart.low) chart.high = chart.low + chart.step;
}

/// Which of the crossing's factors are along the axis, lines and panels.
struct ChartFactors {
  std::size_t across = 0;
  std::optional<std::size_t> along;
  std::vector<std::size_t> panels;

  explicit ChartFactors(const Crossing& crossing) {
    for (std::size_t i = 1; i < crossing.levels.size(); ++i)
      if (crossing.levels[i].size() > crossing.levels[across].size()) across = i;
    for (std::size_t i = 0; i < crossing.levels.size(); ++i) {
      if (i == across) continue;
      if (!along)
        along = i;
      else
        panels.push_back(i);
    }
  }
};

/// The index of each factor's level in a cell.
std::vector<std::size_t> levels_of_cell(const Crossing& crossing, std::size_t cell) {
  std::vector<std::size_t> levels(crossing.levels.size());
  for (std::size_t i = levels.size(); i-- > 0;) {
    levels[i] = cell % crossing.levels[i].size();
    cell /= crossing.levels[i].size();
  }
  return levels;
}

CellChart cell_chart(const Results& results, const ScaleEffects& effects) {
  const AnswerSet& answer_set = results.answer_set;
  const Crossing& crossing = results.effects.crossing;
  const ChartFactors factors(crossing);
  const std::vector<std::string> names = factor_names(answer_set.factors, crossing);
  const Scale& scale = answer_set.scales[effects.scale];
  CellChart chart;
  chart.title = fmt::format("Means by {}: {} – {}", fmt::join(names, " × "), scale.low, scale.high);
  chart.words = fmt::format(
      "Scale units, higher: more {}; 95 % intervals within participants; {}", scale.high,
      counted_noun(static_cast<std::size_t>(effects.people), "participant", "participants"));
  chart.across = names[factors.across];
  chart.levels = crossing.levels[factors.across];
  if (factors.along) {
    chart.along = names[*factors.along];
    chart.lines = crossing.levels[*factors.along];
  }
  for (const FactorCell& cell : effects.cells) {
    const std::vector<std::size_t> levels = levels_of_cell(crossing, cell.cell);
    std::vector<std::string> parts;
    if (!cell.group.empty())
      parts.push_back(
          fmt::format("{} {} (n = {})", results.effects.between, cell.group, cell.people));
    for (const std::size_t factor : factors.panels)
      parts.push_back(names[factor] + " " + crossing.levels[factor][levels[factor]]);
    const std::string name = fmt::format("{}", fmt::join(parts, ", "));
    auto panel = std::ranges::find(chart.panels, name, &CellPanel::name);
    if (panel == chart.panels.end())
      panel = chart.panels.insert(
          panel, {name, std::vector<LevelLine>(std::max<std::size_t>(1, chart.lines.size()))});
    LevelLine& line = panel->lines[factors.along ? levels[*factors.along] : 0];
    line.means.resize(chart.levels.size());
    line.margins.resize(chart.levels.size());
    line.means[levels[factors.across]] = cell.mean;
    line.margins[levels[factors.across]] = cell.margin;
  }
  set_cell_axis(chart);
  return chart;
}

}  // namespace

void add_factor_figures(const Results& results, std::vector<ResultFigure>& figures) {
  for (const ScaleEffects& effects : results.effects.scales) {
    if (effects.cells.empty()) continue;
    figures.push_back({"cell-means-" + results.answer_set.scales[effects.scale].id, "factors", "",
                       "",
                       "Means of the participants’ means of each cell, with 95 % intervals for "
                       "comparisons within "
                       "participants (Cousineau and Morey).",
                       with_simulated_mark(cell_plot(cell_chart(results, effects)),
                                           results.answer_set.simulated)});
  }
}

}  // namespace mien::pipeline
