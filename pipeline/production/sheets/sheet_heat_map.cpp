#include <fmt/format.h>

#include "pipeline/production/sheets/sheet_parts.h"

namespace mien::pipeline {

namespace {

using motion::BodyJoint;

constexpr double cell_gap = 0.8;

void draw_joint_name(Canvas& canvas, BodyJoint joint, NameLanguage names, const Box& row) {
  const double baseline = row.middle() + 2.9;
  if (names != NameLanguage::both) {
    canvas.text({row.x, baseline},
                name_in(names, spoken_name(joint), std::string(motion::japanese_name_of(joint))),
                {.size = 8.0, .max_width = name_width - 8.0});
    return;
  }
  canvas.text({row.x, baseline}, spoken_name(joint), {.size = 8.0});
  canvas.text({row.x + name_width - 8.0, baseline}, motion::japanese_name_of(joint),
              {.size = 7.5, .colour = quiet_ink, .align = Align::right});
}

/// The colour scale with its ends and the threshold named.
void draw_colour_scale(Canvas& canvas, double limit, const Box& box) {
  constexpr int steps = 60;
  for (int i = 0; i < steps; ++i) {
    // Each step reaches under the next, so that no seam shows between them.
    const double x = box.x + box.width * i / steps;
    canvas.fill(Box{x, box.y, box.right() - x, box.height}, amount_colour((i + 0.5) / steps));
  }
  const TextStyle style = {.size = 8.0, .colour = quiet_ink};
  const double baseline = box.bottom() - 0.5;
  TextStyle before = style;
  before.align = Align::right;
  canvas.text({box.x - 5.0, baseline}, "0", before);
  canvas.text({box.right() + 5.0, baseline}, fmt::format("{:.2f} m", limit), style);
  const double threshold = box.x + box.width * motion::distance_threshold_m / limit;
  canvas.line({threshold, box.y - 2.0}, {threshold, box.bottom() + 1.0}, {.width = 0.8});
  TextStyle above = style;
  above.align = Align::centre;
  canvas.text({threshold, box.y - 4.0}, fmt::format("{:.2f}", motion::distance_threshold_m), above);
}

}  // namespace

void draw_heat_map(Canvas& canvas, const SheetContent& content, const Box& box) {
  const double limit = amount_limit(content.distance);
  draw_heading(canvas, {box.x, box.y + 10.0}, "Joint distances over time",
               "metres between target and created");
  draw_colour_scale(canvas, limit, {box.right() - 226.0, box.y + 3.0, 180.0, 7.0});
  for (int j = 1; j <= motion::distance_joints; ++j) {
    const Box row = joint_row(box, j);
    draw_joint_name(canvas, BodyJoint(j), content.names, row);
    for (int t = 0; t < motion::distance_times; ++t) {
      const Box column = time_column(box, t);
      const double amount = content.distance.by_joint_and_time(j - 1, t);
      canvas.fill(Box{column.x + 0.5 * cell_gap, row.y + 0.5 * cell_gap, column.width - cell_gap,
                      row.height - cell_gap},
                  amount_colour(amount / limit));
    }
  }
  const Box means = mean_row(box);
  canvas.text({box.x, means.middle() + 2.9}, "Mean of joints", {.size = 8.0, .bold = true});
  const auto by_time = content.distance.by_time();
  for (int t = 0; t < motion::distance_times; ++t) {
    const Box column = time_column(box, t);
    canvas.text({column.x + 0.5 * column.width, means.middle() + 2.9},
                fmt::format("{:.3f}", by_time[static_cast<std::size_t>(t)]),
                {.size = 8.0, .align = Align::centre});
  }
}

}  // namespace mien::pipeline
