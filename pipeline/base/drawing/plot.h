#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/base/drawing/canvas.h"

namespace mien::pipeline {

/// A drawing of one page, independent of the output format.
struct Plot {
  std::string title;   ///< title of the PDF
  double width = 0.0;  ///< points
  double height = 0.0;
  std::function<void(Canvas&)> draw;
};

std::string as_pdf(const Plot& plot);
std::string as_svg(const Plot& plot);
std::string as_png(const Plot& plot, double dots_per_inch = 200.0);

/// Writes name.pdf, name.svg and name.png, the PNG with 200 dots per inch or, if these would be
/// more than 3 million pixels, with 3 million pixels. Throws as Canvas::pdf does, and WriteFailure
/// if a file cannot be written.
void write_plot(const Plot& plot, const std::filesystem::path& folder, const std::string& name);

inline constexpr std::string_view simulated_ratings_mark = "Simulated ratings";

/// Draws the label of pages based on simulated data: a box with rounded ends, its top right corner
/// at `corner`, and text of `size` points. Returns its box.
Box draw_simulated_mark(Canvas& canvas, Point corner,
                        std::string_view words = simulated_ratings_mark, double size = 8.5);

/// Tick values from 0 up to `most`, in at most `count` steps of 1, 2 or 5 times a power of ten.
/// Only 0 when `most` is not above 0.
std::vector<double> axis_ticks(double most, int count);

}  // namespace mien::pipeline
