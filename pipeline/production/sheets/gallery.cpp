#include "pipeline/production/sheets/gallery.h"

#include <fmt/format.h>

#include "pipeline/base/drawing/figure_drawing.h"
#include "pipeline/base/drawing/plot.h"
#include "pipeline/production/sheets/sheet_parts.h"

namespace mien::pipeline {

namespace {

constexpr double page_width = 1190.55;
constexpr double gallery_margin = 36.0;
constexpr double gallery_header = 56.0;
constexpr double gallery_footer = 30.0;
constexpr double motion_height = 84.0;
constexpr double label_width = 205.0;
constexpr int gallery_pixels_wide = 3508;

double page_height(const GalleryContent& content) {
  return 2.0 * gallery_margin + gallery_header + gallery_footer +
         motion_height * static_cast<double>(content.motions.size());
}

std::vector<Figure> figures_of(const GalleryContent& content, const SheetMotion& shown) {
  std::vector<Figure> figures;
  for (int t = 0; t < motion::distance_times; ++t) {
    const double seconds = motion::corresponding_time(content.motions.front().motion, shown.motion,
                                                      t / (motion::distance_times - 1.0));
    figures.push_back(
        figure_of(shown.motion.clip.body,
                  motion::aligned_pose_at(shown.motion.clip, seconds, motion::Alignment::pelvis)));
  }
  return figures;
}

void draw_title(Canvas& canvas, const GalleryContent& content) {
  const double baseline = gallery_margin + 16.0;
  const Box title =
      canvas.text({gallery_margin, baseline}, content.title, {.size = 18.0, .bold = true});
  canvas.text({title.right() + 10.0, baseline}, content.study, {.size = 11.0, .colour = quiet_ink});
  canvas.text({gallery_margin, baseline + 17.0},
              fmt::format("{} motions at corresponding moments; D relative to the first",
                          content.motions.size()),
              {.size = 9.0, .colour = quiet_ink});
  if (!content.simulated_ratings) return;
  canvas.text({page_width - gallery_margin, baseline}, simulated_ratings_mark,
              {.size = 11.0, .colour = caution_ink, .bold = true, .align = Align::right});
}

void draw_label(Canvas& canvas, const GalleryContent& content, const SheetMotion& shown,
                const Box& row, const Colour& colour) {
  const TextStyle quiet = {.size = 8.0, .colour = quiet_ink, .max_width = label_width - 12.0};
  canvas.text({row.x, row.middle() - 12.0}, shown.id,
              {.size = 11.0, .colour = colour, .bold = true, .max_width = label_width - 12.0});
  canvas.text({row.x, row.middle() + 1.0}, shown.origin, quiet);
  std::string facts = fmt::format("{:.2f} s", shown.motion.clip.duration_seconds());
  const auto place = static_cast<std::size_t>(&shown - content.motions.data());
  if (place > 0) facts += fmt::format(", D = {:.3f} m", content.distances_m[place]);
  canvas.text({row.x, row.middle() + 13.0}, facts, quiet);
}

void draw_rows(Canvas& canvas, const GalleryContent& content) {
  std::vector<std::vector<Figure>> rows;
  FigureExtent extent;
  for (const SheetMotion& shown : content.motions) {
    rows.push_back(figures_of(content, shown));
    for (const Figure& figure : rows.back()) extent.include(figure);
  }
  const double column = (page_width - 2.0 * gallery_margin - label_width) / motion::distance_times;
  const double scale = std::min((column - 6.0) / (extent.right - extent.left),
                                (motion_height - 12.0) / (extent.top - extent.bottom));
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const Box row = {gallery_margin,
                     gallery_margin + gallery_header + motion_height * static_cast<double>(r),
                     page_width - 2.0 * gallery_margin, motion_height};
    const MotionColours& colours = content.colours[r];
    const double ground = row.bottom() - 5.0 + scale * extent.bottom;
    canvas.line({row.x + label_width, ground}, {row.right(), ground},
                {.width = 0.7, .colour = hairline});
    draw_label(canvas, content, content.motions[r], row, colours.line);
    for (std::size_t t = 0; t < rows[r].size(); ++t) {
      const double pelvis = row.x + label_width + column * (static_cast<double>(t) + 0.5) -
                            0.5 * scale * (extent.left + extent.right);
      draw_figure(canvas, rows[r][t], {colours}, {scale, {pelvis, ground}});
    }
  }
}

std::string drawn(Canvas& canvas, const GalleryContent& content) {
  draw_title(canvas, content);
  draw_rows(canvas, content);
  std::string facts = "lighter limbs: left side";
  for (const auto& [name, value] : content.provenance) facts += "  ·  " + name + " " + value;
  canvas.text({gallery_margin, page_height(content) - gallery_margin}, facts,
              {.size = 8.0, .colour = quiet_ink});
  return canvas.finish();
}

}  // namespace

std::string gallery_as_pdf(const GalleryContent& content) {
  return drawn(*Canvas::pdf(page_width, page_height(content), content.title), content);
}

std::string gallery_as_png(const GalleryContent& content) {
  return drawn(*Canvas::png(page_width, page_height(content), gallery_pixels_wide), content);
}

}  // namespace mien::pipeline
