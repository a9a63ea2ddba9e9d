#include "pipeline/production/report/fit_chart.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

namespace mien::pipeline {

namespace {

constexpr double chart_width = 640.0;
constexpr double chart_left = 84.0;
constexpr double chart_right = chart_width - 12.0;
constexpr double chart_top = 18.0;
constexpr double curve_height = 72.0;
constexpr double gap_row_height = 9.0;
constexpr double least_gap_width =
    0.8;  // points; a single frame of a long recording would not be seen
constexpr std::size_t most_rows = 60;
constexpr int most_seconds_ticks = 8;
constexpr int columns = 540;
constexpr Colour missing_colour = from_hex(0x9c2a10);
constexpr Colour filled_colour = from_hex(0xf0b640);
constexpr Colour curve_colour = from_hex(0x2a62b8);

/// Points with gaps within the clip.
std::vector<const motion::FittedPoint*> points_with_gaps(const motion::FitQuality& fit) {
  const int frames = static_cast<int>(fit.frame_residual_mm.size());
  std::vector<const motion::FittedPoint*> rows;
  for (const motion::FittedPoint& point : fit.points) {
    const bool has_gap = std::ranges::any_of(point.gaps, [&](const motion::PointGap& gap) {
      return gap.past > fit.first_frame && gap.first < fit.first_frame + frames;
    });
    if (has_gap) rows.push_back(&point);
  }
  return rows;
}

struct FitLayout {
  Box curve;
  int frames = 1;
  double rate = 30.0;
  double most_mm = 1.0;

  double x_of(double frame) const { return curve.x + curve.width * frame / frames; }
  double y_of(double mm) const { return curve.bottom() - curve.height * mm / most_mm; }
};

double largest(const motion::FitQuality& fit) {
  double most = 1.0;
  for (const std::optional<double>& mm : fit.frame_residual_mm)
    most = std::max(most, mm.value_or(0));
  return most;
}

void draw_fit_axes(Canvas& canvas, const FitLayout& layout, double bottom) {
  const TextStyle centred = {.size = 7.5, .colour = quiet_ink, .align = Align::centre};
  const TextStyle right = {.size = 7.5, .colour = quiet_ink, .align = Align::right};
  for (const double tick : axis_ticks(layout.most_mm, 3)) {
    if (tick > layout.most_mm) continue;
    const double y = layout.y_of(tick);
    canvas.line({layout.curve.x, y}, {layout.curve.right(), y}, {.width = 0.5, .colour = hairline});
    canvas.text({layout.curve.x - 4.0, y + 2.5}, fmt::format("{:g} mm", tick), right);
  }
  const double seconds = layout.frames / layout.rate;
  for (const double tick : axis_ticks(seconds, most_seconds_ticks)) {
    if (tick > seconds + 1e-9) continue;
    const double x = layout.x_of(tick * layout.rate);
    canvas.line({x, layout.curve.y}, {x, bottom}, {.width = 0.5, .colour = hairline});
    canvas.text({x, bottom + 10.0}, fmt::format("{:g}", tick), centred);
  }
  canvas.text({layout.curve.x - 4.0, bottom + 10.0}, "seconds", right);
}

/// Without a line over frames in which no point was seen.
void draw_curve(Canvas& canvas, const FitLayout& layout, const motion::FitQuality& fit) {
  const LineStyle style = {.width = 1.0, .colour = curve_colour};
  const int per_column = std::max(1, (layout.frames + columns - 1) / columns);
  std::vector<Point> line;
  const auto end_line = [&] {
    if (line.size() == 1) line.push_back({line.front().x + least_gap_width, line.front().y});
    if (!line.empty()) canvas.polyline(line, style);
    line.clear();
  };
  for (int first = 0; first < layout.frames; first += per_column) {
    std::optional<double> most;
    for (int frame = first; frame < std::min(first + per_column, layout.frames); ++frame) {
      const std::optional<double>& mm = fit.frame_residual_mm[static_cast<std::size_t>(frame)];
      if (mm) most = std::max(most.value_or(0.0), *mm);
    }
    if (most) {
      line.push_back({layout.x_of(first + 0.5 * per_column), layout.y_of(*most)});
    } else {
      end_line();
    }
  }
  end_line();
}

void draw_gaps(Canvas& canvas, const FitLayout& layout, const motion::FitQuality& fit,
               const motion::FittedPoint& point, double top) {
  canvas.text({layout.curve.x - 4.0, top + 7.0}, point.name,
              {.size = 7.0, .colour = quiet_ink, .align = Align::right, .max_width = 74.0});
  for (const motion::PointGap& gap : point.gaps) {
    const int first = std::max(gap.first - fit.first_frame, 0);
    const int past = std::min(gap.past - fit.first_frame, layout.frames);
    if (past <= first) continue;
    const double x = layout.x_of(first);
    const double width = std::max(layout.x_of(past) - x, least_gap_width);
    const Box bar = gap.filled ? Box{x, top + 2.5, width, gap_row_height - 5.0}
                               : Box{x, top + 1.0, width, gap_row_height - 2.0};
    canvas.fill(bar, gap.filled ? filled_colour : missing_colour);
  }
}

void draw_fit_legend(Canvas& canvas, bool has_gaps) {
  const TextStyle style = {.size = 7.5, .colour = quiet_ink};
  canvas.text({chart_left, 10.0}, "distance from the points (RMS of each frame)", style);
  if (!has_gaps) return;
  double x = chart_right - canvas.text_width("missing", style);
  canvas.text({x, 10.0}, "missing", style);
  canvas.fill(Box{x - 17.0, 4.0, 13.0, 7.0}, missing_colour);
  x -= 28.0 + canvas.text_width("filled", style);
  canvas.text({x, 10.0}, "filled", style);
  canvas.fill(Box{x - 17.0, 5.5, 13.0, 4.0}, filled_colour);
}

}  // namespace

Plot fit_chart(const motion::FitQuality& fit) {
  const std::size_t rows = points_with_gaps(fit).size();
  const double below = chart_top + curve_height;
  const double bottom = below + 6.0 +
                        gap_row_height * static_cast<double>(std::min(rows, most_rows)) +
                        (rows > most_rows ? gap_row_height : 0.0);
  Plot plot{"Fit over time", chart_width, bottom + 16.0, {}};
  // The rows point into the plot's own copy of the fit.
  plot.draw = [fit, bottom, below](Canvas& canvas) {
    const std::vector<const motion::FittedPoint*> shown = points_with_gaps(fit);
    draw_fit_legend(canvas, !shown.empty());
    const FitLayout layout = {{chart_left, chart_top, chart_right - chart_left, curve_height},
                              std::max(static_cast<int>(fit.frame_residual_mm.size()), 1),
                              fit.frames_per_second,
                              1.1 * largest(fit)};
    draw_fit_axes(canvas, layout, bottom);
    if (!fit.frame_residual_mm.empty()) draw_curve(canvas, layout, fit);
    double top = below + 6.0;
    for (std::size_t i = 0; i < std::min(shown.size(), most_rows); ++i, top += gap_row_height)
      draw_gaps(canvas, layout, fit, *shown[i], top);
    if (shown.size() > most_rows)
      canvas.text({chart_left, top + 7.0},
                  fmt::format("and {} more points with gaps", shown.size() - most_rows),
                  {.size = 7.0, .colour = quiet_ink});
  };
  return plot;
}

}  // namespace mien::pipeline
