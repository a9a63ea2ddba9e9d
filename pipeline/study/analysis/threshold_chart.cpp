#include <algorithm>

#include <fmt/format.h>

#include "pipeline/study/analysis/quantification.h"

namespace mien::pipeline {

namespace {

constexpr double width = 520.0;
constexpr double height = 250.0;
constexpr double max_threshold = 2.0;
constexpr int most_ticks = 5;
constexpr Colour curve_colour = from_hex(0x0a58a6);

/// A panel, and where values lie in it.
struct Panel {
  Box plot;
  double most = 1.0;

  Point at(double threshold, double retained) const {
    return {plot.x + plot.width * threshold / max_threshold,
            plot.bottom() - plot.height * retained / most};
  }
};

void draw_axes(Canvas& canvas, const Panel& panel, const std::string& title) {
  canvas.text({panel.plot.x, panel.plot.y - 10.0}, title, {.size = 9.0, .bold = true});
  for (const double tick : axis_ticks(panel.most, most_ticks)) {
    const Point left = panel.at(0.0, tick);
    canvas.line(left, {panel.plot.right(), left.y}, {.width = 0.5, .colour = hairline});
    canvas.text({left.x - 6.0, left.y + 3.0}, fmt::format("{:g}", tick),
                {.size = 8.0, .colour = quiet_ink, .align = Align::right});
  }
  for (const double tick : axis_ticks(max_threshold, 4))
    canvas.text({panel.at(tick, 0.0).x, panel.plot.bottom() + 13.0}, fmt::format("{:g}", tick),
                {.size = 8.0, .colour = quiet_ink, .align = Align::centre});
}

void draw_curve(Canvas& canvas, const Panel& panel, const std::vector<ThresholdPoint>& curve,
                ThresholdPoint::Condition condition) {
  std::vector<Point> alone;
  std::vector<Point> together;
  for (const ThresholdPoint& at : curve) {
    if (at.condition != condition) continue;
    alone.push_back(panel.at(at.threshold, at.by_condition));
    together.push_back(panel.at(at.threshold, at.by_both));
  }
  canvas.polyline(alone, {.width = 1.0, .colour = curve_colour});
  canvas.polyline(together, {.width = 2.4, .colour = curve_colour});
}

void draw_panel(Canvas& canvas, const Panel& panel, const std::vector<ThresholdPoint>& curve,
                ThresholdPoint::Condition condition, double in_use) {
  const bool is_mean = condition == ThresholdPoint::Condition::largest_mean;
  draw_axes(canvas, panel, is_mean ? "largest |mean| at least" : "mean SD at most");
  draw_curve(canvas, panel, curve, condition);
  const double x = panel.at(std::min(in_use, max_threshold), 0.0).x;
  canvas.line({x, panel.plot.y}, {x, panel.plot.bottom()}, {.width = 1.0, .dashed = true});
}

}  // namespace

Plot threshold_chart(const std::vector<ThresholdPoint>& curve, const Thresholds& thresholds,
                     int scales, bool simulated) {
  Plot plot{"Scales kept at other thresholds", width, height, {}};
  plot.draw = [=](Canvas& canvas) {
    canvas.text({24.0, 28.0}, "Scales kept at other thresholds", {.size = 13.0, .bold = true});
    canvas.text({24.0, 44.0},
                "for answers from −2 to 2; thin: this criterion alone, thick: both; dashed: in use",
                {.size = 8.5, .colour = quiet_ink});
    if (simulated) draw_simulated_mark(canvas, {width - 24.0, 12.0});
    const double most = std::max(1, scales);
    const Panel left{{52.0, 84.0, 190.0, 132.0}, most};
    const Panel right{{300.0, 84.0, 190.0, 132.0}, most};
    draw_panel(canvas, left, curve, ThresholdPoint::Condition::largest_mean,
               thresholds.largest_mean);
    draw_panel(canvas, right, curve, ThresholdPoint::Condition::mean_deviation,
               thresholds.mean_deviation);
  };
  return plot;
}

}  // namespace mien::pipeline
