#include <string>

#include <fmt/format.h>

#include "pipeline/production/sheets/sheet_parts.h"

namespace mien::pipeline {

namespace {

/// Metres along the bars.
struct BarScale {
  double start;
  double points_per_metre;

  double at(double metres) const { return start + points_per_metre * metres; }
};

void draw_threshold(Canvas& canvas, const BarScale& scale, const Box& box) {
  const double x = scale.at(motion::distance_threshold_m);
  const double bottom = mean_row(box).bottom();
  canvas.line({x, joint_row(box, 1).y - 1.0}, {x, bottom},
              {.width = 0.8, .colour = quiet_ink, .dashed = true});
  canvas.text({x, bottom + 8.5}, fmt::format("{:g} m", motion::distance_threshold_m),
              {.size = 7.5, .colour = quiet_ink, .align = Align::centre});
}

/// Metres with three decimals, or as many more as show on which side of the threshold they are.
std::string metres_text(double metres) {
  const bool far = metres >= motion::distance_threshold_m;
  int digits = 3;
  std::string text = fmt::format("{:.{}f}", metres, digits);
  while (digits < 6 && (std::stod(text) >= motion::distance_threshold_m) != far)
    text = fmt::format("{:.{}f}", metres, ++digits);
  return text;
}

void draw_bar(Canvas& canvas, const BarScale& scale, const Box& row, double metres, bool bold) {
  const bool far = metres >= motion::distance_threshold_m;
  canvas.fill(Box{scale.start, row.y + 1.6, scale.points_per_metre * metres, row.height - 3.2},
              far ? ink : from_hex(0x9aa3ad));
  canvas.text({row.right(), row.middle() + 2.9}, metres_text(metres),
              {.size = 8.0, .bold = bold, .align = Align::right});
}

}  // namespace

void draw_joint_bars(Canvas& canvas, const SheetContent& content, const Box& box) {
  const double limit = amount_limit(content.distance);
  const BarScale scale = {box.x, (box.width - 36.0) / limit};
  draw_heading(
      canvas, {box.x, box.y + 10.0}, "Mean over time",
      fmt::format("bar: mean (black: ≥ {:g} m); tick: maximum", motion::distance_threshold_m));
  draw_threshold(canvas, scale, box);
  const auto means = content.distance.by_joint();
  for (int j = 1; j <= motion::distance_joints; ++j) {
    const Box row = joint_row(box, j);
    draw_bar(canvas, scale, row, means[static_cast<std::size_t>(j - 1)], false);
    const double most = scale.at(content.distance.by_joint_and_time.row(j - 1).maxCoeff());
    canvas.line({most, row.y + 1.6}, {most, row.bottom() - 1.6}, {.width = 1.0});
  }
  draw_bar(canvas, scale, mean_row(box), content.distance.mean, true);
  canvas.line({scale.start, joint_row(box, 1).y}, {scale.start, mean_row(box).bottom()},
              {.width = 0.7, .colour = quiet_ink});
}

}  // namespace mien::pipeline
