#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "motion/skeleton/clip.h"
#include "pipeline/base/drawing/figure_drawing.h"
#include "pipeline/production/sheets/sheet_parts.h"

namespace mien::pipeline {

namespace {

/// A motion's figures at the eleven times.
struct FigureRow {
  std::string title;
  std::vector<std::string> remarks;
  Colour title_colour = ink;
  struct Layer {
    std::vector<Figure> figures;
    FigureStyle style;
  };
  std::vector<Layer> layers;
};

FigureRow::Layer layer_of(const SheetContent& content, const SheetMotion& shown,
                          const MotionColours& colours, double thickness = 1.0, bool halo = true) {
  FigureRow::Layer layer{{}, {colours, thickness, halo}};
  for (int t = 0; t < motion::distance_times; ++t) {
    const double seconds = motion::corresponding_time(content.target.motion, shown.motion,
                                                      t / (motion::distance_times - 1.0));
    // Each in its column, whatever the distance was aligned by: travel would leave the page.
    layer.figures.push_back(
        figure_of(shown.motion.clip.body,
                  motion::aligned_pose_at(shown.motion.clip, seconds, motion::Alignment::pelvis)));
  }
  return layer;
}

FigureRow row_of(const SheetContent& content, const SheetMotion& shown, const char* title,
                 const char* japanese, const MotionColours& colours) {
  return {
      name_in(content.names, title, japanese),
      {shown.id, fmt::format("{:.2f} s, {}", shown.motion.clip.duration_seconds(), shown.origin)},
      colours.line,
      {layer_of(content, shown, colours)}};
}

std::vector<FigureRow> rows_of(const SheetContent& content) {
  std::vector<FigureRow> rows;
  if (content.reference) {
    rows.push_back(row_of(content, *content.reference, "Reference", "参照", reference_colours));
  }
  rows.push_back(row_of(content, content.target, "Target", "目標", target_colours));
  rows.push_back(row_of(content, content.created, "Created", "作成", created_colours));
  rows.push_back({name_in(content.names, "Overlay", "重ね合わせ"),
                  {"thick: target, thin: created", "lighter limbs: left side"},
                  ink,
                  {layer_of(content, content.target, target_pale, 1.7),
                   layer_of(content, content.created, created_colours, 0.6, false)}});
  return rows;
}

FigureExtent extent_of(const std::vector<FigureRow>& rows) {
  FigureExtent extent;
  for (const FigureRow& row : rows) {
    for (const auto& layer : row.layers) {
      for (const Figure& figure : layer.figures) extent.include(figure);
    }
  }
  return extent;
}

void draw_row_title(Canvas& canvas, const FigureRow& row, const Box& box) {
  const double middle = box.y + 0.5 * box.height;
  canvas.text(
      {box.x, middle - 8.0}, row.title,
      {.size = 11.0, .colour = row.title_colour, .bold = true, .max_width = name_width - 6.0});
  double baseline = middle + 5.0;
  for (const std::string& remark : row.remarks) {
    canvas.text({box.x, baseline}, remark,
                {.size = 8.0, .colour = quiet_ink, .max_width = name_width - 6.0});
    baseline += 11.0;
  }
}

}  // namespace

void draw_figures(Canvas& canvas, const SheetContent& content, const Box& box) {
  constexpr double heading = 16.0;
  const std::vector<FigureRow> rows = rows_of(content);
  const FigureExtent extent = extent_of(rows);
  const double row_height = (box.height - heading) / static_cast<double>(rows.size());
  const double column_width = time_column(box, 0).width;
  const double scale = std::min((column_width - 8.0) / (extent.right - extent.left),
                                (row_height - 14.0) / (extent.top - extent.bottom));

  canvas.text({box.x, box.y + 9.0}, "Keytime-normalized time",
              {.size = 8.0, .colour = quiet_ink, .max_width = name_width - 6.0});
  for (int t = 0; t < motion::distance_times; ++t) {
    const Box column = time_column(box, t);
    canvas.text({column.x + 0.5 * column.width, box.y + 9.0}, fmt::format("{} %", 10 * t),
                {.size = 8.0, .colour = quiet_ink, .align = Align::centre});
  }
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const Box row = {box.x, box.y + heading + static_cast<double>(r) * row_height, box.width,
                     row_height};
    const double ground = row.bottom() - 7.0 + scale * extent.bottom;
    canvas.line({time_column(box, 0).x, ground}, {box.right(), ground},
                {.width = 0.7, .colour = hairline});
    draw_row_title(canvas, rows[r], row);
    for (int t = 0; t < motion::distance_times; ++t) {
      const Box column = time_column(box, t);
      const double pelvis =
          column.x + 0.5 * column.width - 0.5 * scale * (extent.left + extent.right);
      for (const auto& layer : rows[r].layers) {
        draw_figure(canvas, layer.figures[static_cast<std::size_t>(t)], layer.style,
                    {scale, {pelvis, ground}});
      }
    }
  }
}

}  // namespace mien::pipeline
