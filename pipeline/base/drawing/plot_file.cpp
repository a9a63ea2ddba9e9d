#include "pipeline/base/drawing/plot_file.h"

#include "motion/error.h"

namespace mien::pipeline {

void require_plot_file(const std::filesystem::path& file) {
  const std::string extension = file.extension().string();
  if (extension != ".png" && extension != ".svg" && extension != ".pdf")
    throw Error({file.string()}, "is no name of a figure", "end it in .png, .svg or .pdf");
}

std::string plot_for_file(const Plot& plot, const std::filesystem::path& file) {
  require_plot_file(file);
  const std::string extension = file.extension().string();
  if (extension == ".pdf") return as_pdf(plot);
  return extension == ".svg" ? as_svg(plot) : as_png(plot);
}

}  // namespace mien::pipeline
