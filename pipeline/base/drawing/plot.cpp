#include "pipeline/base/drawing/plot.h"

#include <algorithm>
#include <cmath>

#include "pipeline/base/documents/files.h"

namespace mien::pipeline {

namespace {

constexpr double fine_dots_per_inch = 200.0;
constexpr double most_pixels = 3e6;  // a tree of 500 scales would have 23 million

/// Resolution of a PNG in dots per inch, lower for very large plots.
double resolution_of(const Plot& plot) {
  const double square_inches = plot.width * plot.height / (72.0 * 72.0);
  return std::min(fine_dots_per_inch, std::sqrt(most_pixels / square_inches));
}

}  // namespace

std::string as_pdf(const Plot& plot) {
  const auto canvas = Canvas::pdf(plot.width, plot.height, plot.title);
  plot.draw(*canvas);
  return canvas->finish();
}

std::string as_svg(const Plot& plot) {
  const auto canvas = Canvas::svg(plot.width, plot.height);
  plot.draw(*canvas);
  return canvas->finish();
}

std::string as_png(const Plot& plot, double dots_per_inch) {
  const auto canvas = Canvas::png(plot.width, plot.height,
                                  static_cast<int>(std::lround(plot.width * dots_per_inch / 72.0)));
  plot.draw(*canvas);
  return canvas->finish();
}

void write_plot(const Plot& plot, const std::filesystem::path& folder, const std::string& name) {
  write_file(folder / (name + ".pdf"), as_pdf(plot));
  write_file(folder / (name + ".svg"), as_svg(plot));
  write_file(folder / (name + ".png"), as_png(plot, resolution_of(plot)));
}

Box draw_simulated_mark(Canvas& canvas, Point corner, std::string_view words, double size) {
  const TextStyle style = {.size = size, .colour = caution_ink, .bold = true};
  const double scale = size / 8.5;
  const double width = canvas.text_width(words, style) + 18.0 * scale;
  const Box pill = {corner.x - width, corner.y, width, 2.0 * size};
  canvas.fill(pill, caution, size);
  canvas.text({pill.x + 9.0 * scale, pill.y + 11.7 * scale}, words, style);
  return pill;
}

std::vector<double> axis_ticks(double most, int count) {
  if (!(most > 0.0)) return {0.0};
  const double power = std::pow(10.0, std::floor(std::log10(most / count)));
  double step = 10.0 * power;
  for (const double factor : {5.0, 2.0, 1.0})
    if (most / (factor * power) <= count * (1.0 + 1e-12)) step = factor * power;
  std::vector<double> ticks;
  for (int i = 0; i * step <= most * (1.0 + 1e-12); ++i) ticks.push_back(i * step);
  return ticks;
}

}  // namespace mien::pipeline
