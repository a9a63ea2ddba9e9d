#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "pipeline/study/analysis/calibration.h"

namespace mien::pipeline {

namespace {

constexpr double page_margin = 24.0;
constexpr double side = 150.0;
constexpr double panel_width = 205.0;
constexpr double panel_height = 215.0;
constexpr double first_panel = 66.0;
constexpr int max_columns = 4;
constexpr Colour perceived_colour = from_hex(0x0a58a6);
constexpr Colour blend_colour = from_hex(0x8a8f98);

/// A square of 0 … 1 both ways.
struct Square {
  Box plot;

  Point at(double requested, double seen) const {
    return {plot.x + plot.width * requested,
            plot.bottom() - plot.height * std::clamp(seen, 0.0, 1.0)};
  }
};

Square square_at(std::size_t index) {
  const auto column = static_cast<double>(index % max_columns);
  const auto row = static_cast<double>(index / max_columns);
  return {{page_margin + 26.0 + column * panel_width, first_panel + 22.0 + row * panel_height, side,
           side}};
}

void draw_frame(Canvas& canvas, const Square& square, const std::string& title) {
  canvas.text({square.plot.x, square.plot.y - 8.0}, title,
              {.size = 9.0, .bold = true, .max_width = side});
  for (const double tick : {0.0, 0.5, 1.0}) {
    const Point left = square.at(0.0, tick);
    const Point low = square.at(tick, 0.0);
    canvas.line(left, square.at(1.0, tick), {.width = 0.5, .colour = hairline});
    canvas.line(low, square.at(tick, 1.0), {.width = 0.5, .colour = hairline});
    canvas.text({left.x - 5.0, left.y + 3.0}, fmt::format("{:g}", tick),
                {.size = 8.0, .colour = quiet_ink, .align = Align::right});
    canvas.text({low.x, low.y + 12.0}, fmt::format("{:g}", tick),
                {.size = 8.0, .colour = quiet_ink, .align = Align::centre});
  }
  canvas.line(square.at(0.0, 0.0), square.at(1.0, 1.0),
              {.width = 0.8, .colour = quiet_ink, .dashed = true});
}

/// The part of the correction's line within the square.
void draw_correction(Canvas& canvas, const Square& square, const Correction& correction) {
  if (!correction.is_usable()) return;
  const double from = std::clamp(correction.request_for(0.0), 0.0, 1.0);
  const double to = std::clamp(correction.request_for(1.0), 0.0, 1.0);
  const auto seen = [&](double requested) {
    return correction.intercept + correction.slope * requested;
  };
  canvas.line(square.at(from, seen(from)), square.at(to, seen(to)),
              {.width = 1.6, .colour = perceived_colour});
  canvas.text({square.plot.x, square.plot.bottom() + 25.0},
              fmt::format("perceived = {:.2f} + {:.2f} · requested", correction.intercept,
                          correction.slope),
              {.size = 8.0, .colour = perceived_colour, .max_width = side});
}

void draw_stimulus(Canvas& canvas, const Square& square, const PerceivedParameter& seen) {
  const double requested = seen.made.requested;
  if (!std::isnan(seen.deviation))
    canvas.line(square.at(requested, seen.perceived - seen.deviation),
                square.at(requested, seen.perceived + seen.deviation),
                {.width = 0.8, .colour = perceived_colour});
  canvas.ring(square.at(requested, seen.made.reached), 3.0, {.width = 1.2, .colour = blend_colour});
  canvas.disc(square.at(requested, seen.perceived), 2.6, perceived_colour);
}

}  // namespace

Plot calibration_chart(const Calibration& calibration) {
  const std::size_t count = calibration.corrections.size();
  const auto columns = static_cast<double>(std::clamp<std::size_t>(count, 2, max_columns));
  const auto rows = static_cast<double>((count + max_columns - 1) / max_columns);
  Plot plot{"Requested and perceived",
            2.0 * page_margin + columns * panel_width,
            first_panel + rows * panel_height + 16.0,
            {}};
  plot.draw = [calibration, width = plot.width](Canvas& canvas) {
    canvas.text({page_margin, 28.0}, "Requested and perceived", {.size = 13.0, .bold = true});
    canvas.text({page_margin, 44.0},
                "x: requested; y: perceived (blue, mean ± SD) and value of the blend (ring)",
                {.size = 8.5, .colour = quiet_ink, .max_width = width - 2.0 * page_margin});
    if (calibration.simulated) draw_simulated_mark(canvas, {width - page_margin, 12.0});
    for (std::size_t i = 0; i < calibration.corrections.size(); ++i) {
      const Correction& correction = calibration.corrections[i];
      const Square square = square_at(i);
      draw_frame(canvas, square, correction.parameter);
      draw_correction(canvas, square, correction);
      for (const PerceivedParameter& seen : calibration.stimuli)
        if (seen.made.parameter == correction.parameter) draw_stimulus(canvas, square, seen);
    }
  };
  return plot;
}

}  // namespace mien::pipeline
