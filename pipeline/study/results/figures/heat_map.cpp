#include "pipeline/study/results/figures/heat_map.h"

#include <algorithm>
#include <cmath>

#include "pipeline/base/drawing/canvas.h"

namespace mien::pipeline {

namespace {

constexpr double map_margin = 18.0;
constexpr double map_header = 46.0;
constexpr double map_names = 104.0;
constexpr double map_heads = 30.0;
constexpr double cell_width = 54.0;
constexpr double cell_height = 22.0;
constexpr double least_map_width = 420.0;

Colour mixed(const Colour& from, const Colour& to, double share) {
  const double t = std::clamp(share, 0.0, 1.0);
  return {from.red + t * (to.red - from.red), from.green + t * (to.green - from.green),
          from.blue + t * (to.blue - from.blue)};
}

/// The text colour with better contrast.
Colour ink_on(const Colour& colour) { return to_oklab(colour)[0] < 0.62 ? paper : ink; }

void draw_map_heads(Canvas& canvas, const HeatMap& map) {
  canvas.text({map_margin, map_margin + 12.0}, map.title, {.size = 12.0, .bold = true});
  canvas.text({map_margin, map_margin + 27.0}, map.words, {.size = 8.5, .colour = quiet_ink});
  const double top = map_margin + map_header + map_heads;
  canvas.text({map_margin, top - 6.0}, map.row_title, {.size = 7.5, .colour = quiet_ink});
  canvas.text({map_margin + map_names, top - 19.0}, map.column_title,
              {.size = 7.5, .colour = quiet_ink});
  for (std::size_t c = 0; c < map.column_names.size(); ++c) {
    const double x = map_margin + map_names + (static_cast<double>(c) + 0.5) * cell_width;
    canvas.text({x, top - 6.0}, map.column_names[c],
                {.size = 8.0, .bold = true, .align = Align::centre, .max_width = cell_width - 3.0});
  }
}

void draw_cell(Canvas& canvas, const Box& box, const HeatCell& cell) {
  const Box inner = {box.x + 0.75, box.y + 0.75, box.width - 1.5, box.height - 1.5};
  canvas.fill(inner, cell.colour, 1.5);
  if (cell.is_outlined) canvas.outline(inner, {.width = 1.3, .colour = ink}, 1.5);
  canvas.text(
      {inner.x + 0.5 * inner.width, inner.middle() + 2.8}, cell.text,
      {.size = 8.0, .colour = ink_on(cell.colour), .bold = cell.is_bold, .align = Align::centre});
}

}  // namespace

Plot heat_map_plot(const HeatMap& map) {
  const double width =
      std::max(least_map_width, 2.0 * map_margin + map_names +
                                    cell_width * static_cast<double>(map.column_names.size()));
  const double height = 2.0 * map_margin + map_header + map_heads +
                        cell_height * static_cast<double>(map.row_names.size());
  return {map.title, width, height, [=](Canvas& canvas) {
            draw_map_heads(canvas, map);
            const double top = map_margin + map_header + map_heads;
            for (std::size_t r = 0; r < map.row_names.size(); ++r) {
              const double y = top + static_cast<double>(r) * cell_height;
              canvas.text({map_margin, y + 0.5 * cell_height + 2.8}, map.row_names[r],
                          {.size = 8.0, .bold = true, .max_width = map_names - 6.0});
              for (std::size_t c = 0; c < map.cells[r].size(); ++c)
                draw_cell(canvas,
                          {map_margin + map_names + static_cast<double>(c) * cell_width, y,
                           cell_width, cell_height},
                          map.cells[r][c]);
            }
            if (map.simulated) draw_simulated_mark(canvas, {width - map_margin, map_margin + 32.0});
          }};
}

Colour signed_colour(double value) {
  return mixed(from_hex(0xf7f7f7), value < 0.0 ? reference_colours.line : created_colours.line,
               std::abs(value));
}

Colour share_colour(double value) { return mixed(from_hex(0xf7f7f7), created_colours.line, value); }

}  // namespace mien::pipeline
