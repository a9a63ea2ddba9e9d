#include "pipeline/study/results/figures/interval_chart.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "pipeline/base/drawing/canvas.h"
#include "pipeline/base/drawing/palette.h"

namespace mien::pipeline {

namespace {

constexpr double interval_margin = 18.0;
constexpr double interval_header = 52.0;
constexpr double interval_row_height = 19.0;
constexpr double interval_axis_height = 34.0;
constexpr double interval_least_axis = 300.0;
constexpr double interval_values_width = 104.0;

double names_width_of(const IntervalChart& chart) {
  constexpr double letter = 4.6;
  std::size_t longest = 0;
  for (const IntervalLine& line : chart.lines)
    if (!std::isnan(line.value) || !line.note.empty())
      longest = std::max(longest, line.name.size());
  return std::clamp(14.0 + letter * static_cast<double>(longest), 90.0, 200.0);
}

double page_width_of(const IntervalChart& chart) {
  constexpr double least = 540.0;
  return std::max(
      2.0 * interval_margin + names_width_of(chart) + interval_least_axis + interval_values_width,
      least);
}

double axis_width_of(const IntervalChart& chart) {
  return page_width_of(chart) - 2.0 * interval_margin - names_width_of(chart) -
         interval_values_width;
}

std::string signed_text(double value) {
  const std::string text = fmt::format("{:.2f}", std::abs(value));
  return (value < 0.0 && text != "0.00" ? "−" : "") + text;
}

void draw_axis(Canvas& canvas, const IntervalChart& chart, const Box& area) {
  const auto x = [&](double value) {
    return area.x + (value - chart.low) / (chart.high - chart.low) * area.width;
  };
  for (double at = chart.low; at < chart.high + 0.5 * chart.step; at += chart.step) {
    const bool is_zero = std::abs(at) < 0.25 * chart.step;
    canvas.line({x(at), area.y}, {x(at), area.bottom()},
                {.width = is_zero ? 0.9 : 0.5, .colour = is_zero ? quiet_ink : hairline});
    const std::string text = fmt::format("{:g}", std::abs(at));
    canvas.text({x(at), area.bottom() + 11.0},
                (at < 0.0 && !is_zero ? "−" : "") + (is_zero ? "0" : text),
                {.size = 7.5, .colour = quiet_ink, .align = Align::centre});
  }
  canvas.text({area.x + 0.5 * area.width, area.bottom() + 24.0}, chart.axis,
              {.size = 8.0, .colour = quiet_ink, .align = Align::centre});
}

void draw_line(Canvas& canvas, const IntervalChart& chart, const IntervalLine& line,
               const Box& row) {
  const double names = names_width_of(chart);
  const double middle = row.middle();
  if (std::isnan(line.value) && line.note.empty()) {  // a heading, before which the axis is hidden
    const TextStyle style = {.size = 8.0, .bold = true};
    canvas.fill(
        Box{row.x, row.y + 1.0, canvas.text_width(line.name, style) + 4.0, row.height - 2.0},
        paper);
    canvas.text({row.x, middle + 2.8}, line.name, style);
    return;
  }
  canvas.text({row.x, middle + 2.8}, line.name, {.size = 8.0, .max_width = names - 6.0});
  const double axis = row.x + names;
  const auto x = [&](double value) {
    const double share = (value - chart.low) / (chart.high - chart.low);
    return axis + std::clamp(share, 0.0, 1.0) * axis_width_of(chart);
  };
  if (std::isnan(line.value)) {
    const TextStyle style = {.size = 7.5, .colour = quiet_ink};
    canvas.fill(
        Box{axis + 2.0, row.y + 3.0, canvas.text_width(line.note, style) + 4.0, row.height - 6.0},
        paper);
    canvas.text({axis + 4.0, middle + 2.8}, line.note, style);
    return;
  }
  const bool has_ends = std::isfinite(line.ends.low) && std::isfinite(line.ends.high);
  if (has_ends)
    canvas.line({x(line.ends.low), middle}, {x(line.ends.high), middle},
                {.width = 1.4, .colour = created_colours.line});
  canvas.disc({x(line.value), middle}, 2.8, created_colours.line);
  std::string text = signed_text(line.value);
  if (has_ends)
    text += fmt::format(" [{}, {}]", signed_text(line.ends.low), signed_text(line.ends.high));
  canvas.text({row.right(), middle + 2.8}, text, {.size = 7.5, .align = Align::right});
  if (!line.note.empty())
    canvas.text({axis + 4.0, middle + 2.8}, line.note, {.size = 6.5, .colour = quiet_ink});
}

}  // namespace

Plot interval_plot(const IntervalChart& chart) {
  const double names = names_width_of(chart);
  const double width = page_width_of(chart);
  const double rows = interval_row_height * static_cast<double>(chart.lines.size());
  const double height = 2.0 * interval_margin + interval_header + rows + interval_axis_height;
  return {
      chart.title, width, height, [=](Canvas& canvas) {
        canvas.text({interval_margin, interval_margin + 12.0}, chart.title,
                    {.size = 12.0, .bold = true});
        canvas.text({interval_margin, interval_margin + 27.0}, chart.words,
                    {.size = 8.5, .colour = quiet_ink});
        const double top = interval_margin + interval_header;
        draw_axis(canvas, chart, {interval_margin + names, top, axis_width_of(chart), rows + 4.0});
        for (std::size_t i = 0; i < chart.lines.size(); ++i)
          draw_line(canvas, chart, chart.lines[i],
                    {interval_margin, top + interval_row_height * static_cast<double>(i),
                     width - 2.0 * interval_margin, interval_row_height});
      }};
}

void set_axis(IntervalChart& chart, bool is_symmetric) {
  double most = 0.5;
  double least = 0.0;
  for (const IntervalLine& line : chart.lines) {
    for (const double value : {line.value, line.ends.low, line.ends.high}) {
      if (!std::isfinite(value)) continue;
      most = std::max(most, is_symmetric ? std::abs(value) : value);
      least = std::min(least, value);
    }
  }
  for (const double step : {0.25, 0.5, 1.0, 2.0, 5.0, 10.0}) {
    chart.step = step;
    if (most / step <= 5.0) break;
  }
  chart.high = chart.step * std::ceil(most / chart.step);
  chart.low = is_symmetric ? -chart.high : chart.step * std::floor(least / chart.step);
}

}  // namespace mien::pipeline
