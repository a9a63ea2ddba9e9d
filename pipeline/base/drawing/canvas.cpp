#include "pipeline/base/drawing/canvas.h"

#include "pipeline/base/drawing/canvas_surface.h"

namespace mien::pipeline {

bool overlap(const Box& a, const Box& b) {
  return a.x < b.right() && b.x < a.right() && a.y < b.bottom() && b.y < a.bottom();
}

std::unique_ptr<Canvas> Canvas::pdf(double width, double height, const std::string& title) {
  return page_libraries().pdf(width, height, title);
}

std::unique_ptr<Canvas> Canvas::svg(double width, double height) {
  return page_libraries().svg(width, height);
}

std::unique_ptr<Canvas> Canvas::png(double width, double height, int pixels_wide) {
  return page_libraries().png(width, height, pixels_wide);
}

}  // namespace mien::pipeline
