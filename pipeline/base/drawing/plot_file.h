#pragma once

#include <filesystem>
#include <string>

#include "pipeline/base/drawing/plot.h"

namespace mien::pipeline {

/// Throws Error unless the file's name ends in .png, .svg or .pdf.
void require_plot_file(const std::filesystem::path& file);

/// The bytes of a plot in the format of the file's extension; a PNG with 200 dots per inch.
/// Throws as require_plot_file and Canvas::pdf do.
std::string plot_for_file(const Plot& plot, const std::filesystem::path& file);

}  // namespace mien::pipeline
