#include "pipeline/base/drawing/bar_chart.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "pipeline/base/drawing/plot.h"

namespace mien::pipeline {

namespace {

constexpr double margin = 18.0;
constexpr double header_height = 52.0;
constexpr double plot_height = 210.0;
constexpr double names_height = 36.0;
constexpr double axis_width = 46.0;
constexpr double widest_bar = 44.0;
constexpr double widest_bar_share = 0.6;  // of its slot
constexpr double gap = 30.0;              // between charts
constexpr double page_title_height = 34.0;
constexpr double least_width = 380.0;
constexpr double line_name_width = 78.0;
constexpr double group_gap = 26.0;
constexpr double group_name_height = 16.0;

constexpr std::array<Colour, 5> bar_colours = {from_hex(0x0a58a6), from_hex(0xb8420e),
                                               from_hex(0x007a59), from_hex(0x8a3f8f),
                                               from_hex(0x8a6a00)};

/// Values along the axis.
struct Scale {
  double least = 0.0;
  double most = 1.0;
  Box plot;

  double y(double value) const {
    return plot.bottom() - plot.height * (value - least) / (most - least);
  }
};

double line_name_room(const BarChart& chart) { return chart.line ? line_name_width : 0.0; }

bool has_groups(const BarChart& chart) {
  return std::ranges::any_of(chart.bars, [](const Bar& bar) { return !bar.group.empty(); });
}

/// Whether a bar is the first of its group.
bool begins_group(const BarChart& chart, size_t bar) {
  return bar == 0 || chart.bars[bar].group != chart.bars[bar - 1].group;
}

/// Gaps between groups up to a bar.
double gaps_before(const BarChart& chart, size_t bar) {
  double gaps = 0.0;
  for (size_t i = 1; i <= bar && i < chart.bars.size(); ++i)
    if (begins_group(chart, i)) gaps += group_gap;
  return gaps;
}

double gaps_of(const BarChart& chart) { return gaps_before(chart, chart.bars.size()); }

size_t place_in_group(const BarChart& chart, size_t bar) {
  size_t place = 0;
  for (size_t i = bar; !begins_group(chart, i); --i) ++place;
  return place;
}

/// Width of axis and bars without the page's margins, points.
double width_of(const BarChart& chart) {
  return axis_width + chart.slot_width * static_cast<double>(chart.bars.size()) + gaps_of(chart) +
         line_name_room(chart);
}

Scale scale_of(const BarChart& chart, const Box& place) {
  Scale scale;
  double least = 0.0;
  double most = chart.percent ? 1.0 : chart.line.value_or(0.0);
  for (const Bar& bar : chart.bars) {
    for (const double value : {bar.value, bar.low, bar.high}) {
      if (!std::isfinite(value)) continue;
      least = std::min(least, value);
      most = std::max(most, value);
    }
  }
  if (most == least) most = least + 1.0;
  const double room = 0.09 * (most - least);  // for the values printed beyond the bars
  scale.least = least < 0.0 ? least - room : 0.0;
  scale.most = most + room;
  scale.plot = {place.x + axis_width, place.y + header_height,
                place.width - axis_width - line_name_room(chart), plot_height};
  return scale;
}

/// A number with a typographic minus sign.
std::string signed_text(std::string number) {
  return number.starts_with('-') ? "−" + number.substr(1) : number;
}

std::string printed(const BarChart& chart, double value) {
  return signed_text(chart.percent ? fmt::format("{:.{}f} %", 100.0 * value, chart.decimals)
                                   : fmt::format("{:.{}f}", value, chart.decimals));
}

std::string axis_label(const BarChart& chart) {
  return chart.whiskers.empty() ? chart.axis : chart.axis + "; whiskers: " + chart.whiskers;
}

/// Width needed by the texts above the bars, points.
double width_of_texts(const BarChart& chart) {
  constexpr double letter = 4.7;  // of these sizes, rather more than usual
  return 2.0 * margin + letter * static_cast<double>(axis_label(chart).size());
}

void draw_header(Canvas& canvas, const BarChart& chart, const Box& place) {
  canvas.text({place.x, place.y + 12.0}, chart.title, {.size = 12.0, .bold = true});
  canvas.text({place.x, place.y + 27.0}, axis_label(chart), {.size = 8.5, .colour = quiet_ink});
}

void draw_axis(Canvas& canvas, const BarChart& chart, const Scale& scale) {
  const double span = scale.most - scale.least;
  const std::vector<double> steps = axis_ticks(span, 7);
  const double step = steps.size() > 1 ? steps[1] : span;
  const double first = std::ceil(scale.least / step - 1e-9);
  for (double k = first + 0.0; k * step <= scale.most + 1e-9 * span; k += 1.0) {
    if (chart.percent && k * step > 1.0 + 1e-9) break;
    const double y = scale.y(k * step);
    canvas.line({scale.plot.x, y}, {scale.plot.right(), y},
                {.width = k == 0.0 ? 0.8 : 0.4, .colour = k == 0.0 ? ink : hairline});
    const double value = k * step + 0.0;  // no −0
    const std::string label = chart.percent ? fmt::format("{:g} %", 100.0 * value)
                                            : signed_text(fmt::format("{:g}", value));
    canvas.text({scale.plot.x - 6.0, y + 2.8}, label,
                {.size = 7.5, .colour = quiet_ink, .align = Align::right});
  }
}

void draw_marked_value(Canvas& canvas, const BarChart& chart, const Scale& scale) {
  if (!chart.line) return;
  const double y = scale.y(*chart.line);
  canvas.line({scale.plot.x, y}, {scale.plot.right(), y},
              {.width = 0.9, .colour = ink, .dashed = true});
  canvas.text({scale.plot.right() + 5.0, y + 2.8}, chart.line_name, {.size = 8.0});
}

void draw_whisker(Canvas& canvas, const Bar& bar, const Scale& scale, double x) {
  if (!std::isfinite(bar.low) || !std::isfinite(bar.high)) return;
  const LineStyle style = {.width = 1.0, .colour = ink};
  canvas.line({x, scale.y(bar.low)}, {x, scale.y(bar.high)}, style);
  for (const double end : {bar.low, bar.high})
    canvas.line({x - 5.0, scale.y(end)}, {x + 5.0, scale.y(end)}, style);
}

double slot_of(const BarChart& chart, const Scale& scale) {
  return (scale.plot.width - gaps_of(chart)) / static_cast<double>(chart.bars.size());
}

/// Horizontal centre of a bar, points.
double middle_of(const BarChart& chart, const Scale& scale, size_t bar) {
  return scale.plot.x + slot_of(chart, scale) * (static_cast<double>(bar) + 0.5) +
         gaps_before(chart, bar);
}

void draw_group_names(Canvas& canvas, const BarChart& chart, const Scale& scale) {
  for (size_t first = 0; first < chart.bars.size();) {
    size_t end = first + 1;
    while (end < chart.bars.size() && !begins_group(chart, end)) ++end;
    const double left = middle_of(chart, scale, first);
    const double right = middle_of(chart, scale, end - 1);
    const double slot = slot_of(chart, scale);
    canvas.text(
        {0.5 * (left + right), scale.plot.bottom() + names_height + 12.0}, chart.bars[first].group,
        {.size = 9.0, .bold = true, .align = Align::centre, .max_width = right - left + slot});
    first = end;
  }
}

void draw_bar(Canvas& canvas, const BarChart& chart, size_t number, const Scale& scale) {
  const Bar& bar = chart.bars[number];
  const double slot = slot_of(chart, scale);
  const double x = middle_of(chart, scale, number);
  const double top = std::min(scale.y(0.0), scale.y(bar.value));
  const double width = std::min(widest_bar, widest_bar_share * slot);
  canvas.fill(
      Box{x - 0.5 * width, top, width, std::abs(scale.y(0.0) - scale.y(bar.value))},
      bar.colour.value_or(
          bar_colours[chart.one_colour ? 0 : place_in_group(chart, number) % bar_colours.size()]));
  draw_whisker(canvas, bar, scale, x);
  // Beyond bar and whisker, away from 0.
  const bool upwards = bar.value >= 0.0;
  double end = bar.value;
  if (std::isfinite(bar.low) && std::isfinite(bar.high))
    end = upwards ? std::max(end, bar.high) : std::min(end, bar.low);
  canvas.text({x, upwards ? scale.y(end) - 5.0 : scale.y(end) + 12.0}, printed(chart, bar.value),
              {.size = 8.5, .bold = true, .align = Align::centre});
  const double below = scale.plot.bottom() + 14.0;
  canvas.text({x, below}, bar.name, {.size = 9.0, .align = Align::centre, .max_width = slot - 6.0});
  canvas.text({x, below + 12.0}, bar.note,
              {.size = 7.5, .colour = quiet_ink, .align = Align::centre, .max_width = slot - 6.0});
  canvas.text({x, below + 22.0}, bar.second_note,
              {.size = 7.5, .colour = quiet_ink, .align = Align::centre});
}

void draw_chart(Canvas& canvas, const BarChart& chart, const Box& place) {
  const Scale scale = scale_of(chart, place);
  draw_header(canvas, chart, place);
  draw_axis(canvas, chart, scale);
  for (size_t i = 0; i < chart.bars.size(); ++i) draw_bar(canvas, chart, i, scale);
  if (has_groups(chart)) draw_group_names(canvas, chart, scale);
  draw_marked_value(canvas, chart, scale);
}

double height_of(const BarChart& chart) {
  return header_height + plot_height + names_height + (has_groups(chart) ? group_name_height : 0.0);
}

}  // namespace

Plot bar_chart_plot(const BarChart& chart) {
  const double width =
      std::max({least_width, 2.0 * margin + width_of(chart), width_of_texts(chart)});
  return {chart.title, width, 2.0 * margin + height_of(chart), [chart, width](Canvas& canvas) {
            draw_chart(canvas, chart, {margin, margin, width - 2.0 * margin, height_of(chart)});
            if (!chart.simulated) return;
            draw_simulated_mark(canvas, {width - margin, margin + 31.0}, "Simulated sessions");
          }};
}

Plot bar_charts_plot(const std::string& title, const std::vector<BarChart>& charts,
                     const std::string& mark) {
  double width = 2.0 * margin - gap;
  for (const BarChart& chart : charts) width += width_of(chart) + gap;
  width = std::max(least_width, width);
  double chart_height = 0.0;
  for (const BarChart& chart : charts) chart_height = std::max(chart_height, height_of(chart));
  const double height = 2.0 * margin + page_title_height + chart_height;
  return {
      title, width, height, [=](Canvas& canvas) {
        canvas.text({margin, margin + 13.0}, title, {.size = 14.0, .bold = true});
        double x = margin;
        for (const BarChart& chart : charts) {
          draw_chart(canvas, chart, {x, margin + page_title_height, width_of(chart), chart_height});
          x += width_of(chart) + gap;
        }
        if (!std::ranges::any_of(charts, &BarChart::simulated)) return;
        draw_simulated_mark(canvas, {width - margin, margin}, mark);
      }};
}

}  // namespace mien::pipeline
