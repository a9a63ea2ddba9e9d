#include "pipeline/study/results/figures/rating_grid.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "pipeline/base/drawing/canvas.h"
#include "pipeline/base/drawing/palette.h"

namespace mien::pipeline {

namespace {

constexpr double grid_margin = 18.0;
constexpr double grid_header = 56.0;
constexpr double heads_height = 20.0;
constexpr double names_width = 150.0;
constexpr double panel_width = 104.0;
constexpr double panel_gap = 12.0;
constexpr double least_grid_width = 540.0;

using DrawPanel = std::function<void(Canvas&, const Box&, const RatingPanel&)>;

double width_of_grid(const RatingGrid& grid) {
  const auto columns = static_cast<double>(grid.columns.size());
  return std::max(least_grid_width,
                  2.0 * grid_margin + names_width + columns * (panel_width + panel_gap));
}

Box panel_box(std::size_t row, std::size_t column, double row_height) {
  return {grid_margin + names_width + panel_gap +
              static_cast<double>(column) * (panel_width + panel_gap),
          grid_margin + grid_header + heads_height + static_cast<double>(row) * row_height,
          panel_width, row_height};
}

void draw_heads(Canvas& canvas, const RatingGrid& grid) {
  canvas.text({grid_margin, grid_margin + 12.0}, grid.title, {.size = 12.0, .bold = true});
  canvas.text({grid_margin, grid_margin + 27.0}, grid.words, {.size = 8.5, .colour = quiet_ink});
  for (std::size_t i = 0; i < grid.columns.size(); ++i) {
    const Box box = panel_box(0, i, 0.0);
    const double half = 0.5 * panel_width - 3.0;
    canvas.text({box.x, box.y - 7.0}, grid.columns[i].low,
                {.size = 8.0, .bold = true, .max_width = half});
    canvas.text({box.right(), box.y - 7.0}, grid.columns[i].high,
                {.size = 8.0, .bold = true, .align = Align::right, .max_width = half});
  }
}

Plot grid_plot(const RatingGrid& grid, double row_height, const DrawPanel& draw_panel) {
  const double width = width_of_grid(grid);
  const double height = 2.0 * grid_margin + grid_header + heads_height +
                        row_height * static_cast<double>(grid.rows.size());
  return {grid.title, width, height, [=](Canvas& canvas) {
            draw_heads(canvas, grid);
            for (std::size_t r = 0; r < grid.rows.size(); ++r) {
              const RatingRow& row = grid.rows[r];
              const double middle = panel_box(r, 0, row_height).middle();
              const bool has_note = !row.note.empty();
              canvas.text({grid_margin, middle + (has_note ? -0.5 : 2.8)}, row.name,
                          {.size = 8.0, .max_width = names_width});
              if (has_note)
                canvas.text({grid_margin, middle + 8.5}, row.note,
                            {.size = 6.5, .colour = quiet_ink, .max_width = names_width});
              for (std::size_t c = 0; c < row.panels.size(); ++c)
                draw_panel(canvas, panel_box(r, c, row_height), row.panels[c]);
            }
            if (grid.simulated)
              draw_simulated_mark(canvas, {width - grid_margin, grid_margin - 2.0});
          }};
}

double largest_share(const RatingGrid& grid) {
  double largest = 0.0;
  for (const RatingRow& row : grid.rows) {
    for (const RatingPanel& panel : row.panels) {
      double sum = 0.0;
      double most = 0.0;
      for (const int count : panel.counts) {
        sum += count;
        most = std::max(most, static_cast<double>(count));
      }
      if (sum > 0.0) largest = std::max(largest, most / sum);
    }
  }
  return largest > 0.0 ? largest : 1.0;
}

void draw_histogram(Canvas& canvas, const Box& row, const RatingPanel& panel, double largest) {
  if (panel.counts.empty()) return;
  const Box box = {row.x, row.y + 3.0, row.width, row.height - 7.0};
  if (panel.is_marked) canvas.fill(box, from_hex(0xfff3d6), 2.0);
  double sum = 0.0;
  for (const int count : panel.counts) sum += count;
  const double slot = box.width / static_cast<double>(panel.counts.size());
  for (std::size_t i = 0; i < panel.counts.size(); ++i) {
    const double height = box.height * panel.counts[i] / (sum * largest);
    canvas.fill(Box{box.x + slot * static_cast<double>(i) + 0.1 * slot, box.bottom() - height,
                    0.8 * slot, height},
                created_colours.light);
  }
  canvas.line({box.x, box.bottom()}, {box.right(), box.bottom()},
              {.width = 0.6, .colour = quiet_ink});
  // The middles of the first and the last bar are the ends of the scale.
  const double x = box.x + 0.5 * slot + panel.mean * (box.width - slot);
  canvas.line({x, box.y}, {x, box.bottom() + 2.5}, {.width = 1.2, .colour = ink});
}

void draw_mean(Canvas& canvas, const Box& row, const RatingPanel& panel) {
  if (panel.counts.empty()) return;
  const Box box = {row.x, row.y + 1.0, row.width, row.height - 2.0};
  canvas.fill(box, panel.is_marked ? from_hex(0xffe9bd) : from_hex(0xf3f5f7), 2.0);
  const double inset = 5.0;
  const auto x = [&](double share) { return box.x + inset + share * (box.width - 2.0 * inset); };
  canvas.line({x(0.5), box.y}, {x(0.5), box.bottom()}, {.width = 0.6, .colour = hairline});
  if (std::isfinite(panel.low) && std::isfinite(panel.high)) {
    const double low = std::clamp(panel.low, 0.0, 1.0);
    const double high = std::clamp(panel.high, 0.0, 1.0);
    canvas.line({x(low), box.middle()}, {x(high), box.middle()},
                {.width = 1.4, .colour = created_colours.line});
  }
  canvas.disc({x(panel.mean), box.middle()}, 2.6, created_colours.line);
}

}  // namespace

Plot histogram_grid_plot(const RatingGrid& grid) {
  const double largest = largest_share(grid);
  return grid_plot(grid, 34.0, [largest](Canvas& canvas, const Box& row, const RatingPanel& one) {
    draw_histogram(canvas, row, one, largest);
  });
}

Plot mean_grid_plot(const RatingGrid& grid) { return grid_plot(grid, 20.0, draw_mean); }

}  // namespace mien::pipeline
