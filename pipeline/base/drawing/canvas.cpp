#include "pipeline/base/drawing/canvas.h"

#include <array>
#include <cassert>
#include <utility>

#include "pipeline/base/drawing/canvas_surface.h"

namespace mien::pipeline {

bool overlap(const Box& a, const Box& b) {
  return a.x < b.right() && b.x < a.right() && a.y < b.bottom() && b.y < a.bottom();
}

Canvas::Canvas(std::unique_ptr<CanvasSurface> surface) : surface_(std::move(surface)) {}
Canvas::Canvas(Canvas&&) noexcept = default;
Canvas& Canvas::operator=(Canvas&&) noexcept = default;
Canvas::~Canvas() = default;

Canvas Canvas::pdf(double width, double height, const std::string& title) {
  return Canvas(page_libraries().pdf(width, height, title));
}

Canvas Canvas::svg(double width, double height) {
  return Canvas(page_libraries().svg(width, height));
}

Canvas Canvas::png(double width, double height, int pixels_wide) {
  return Canvas(page_libraries().png(width, height, pixels_wide));
}

void Canvas::line(Point from, Point to, const LineStyle& style) {
  polyline(std::array{from, to}, style);
}

void Canvas::polyline(std::span<const Point> points, const LineStyle& style) {
  surface_->polyline(points, style);
}

void Canvas::fill(const Box& box, const Colour& colour, double corner_radius) {
  surface_->fill(box, colour, corner_radius);
}

void Canvas::outline(const Box& box, const LineStyle& style, double corner_radius) {
  surface_->outline(box, style, corner_radius);
}

void Canvas::fill(std::span<const Point> polygon, const Colour& colour, double opacity) {
  surface_->fill(polygon, colour, opacity);
}

void Canvas::disc(Point centre, double radius, const Colour& colour) {
  surface_->disc(centre, radius, colour);
}

void Canvas::ring(Point centre, double radius, const LineStyle& style) {
  surface_->ring(centre, radius, style);
}

void Canvas::picture(const Box& box, const render::Image8& image) { surface_->picture(box, image); }

Box Canvas::text(Point baseline, std::string_view utf8, const TextStyle& style) {
  const Box box = surface_->text(baseline, utf8, style);
  texts_.push_back({std::string(utf8), box});
  return box;
}

double Canvas::text_width(std::string_view utf8, const TextStyle& style) const {
  return surface_->text_width(utf8, style);
}

std::string Canvas::finish() {
  assert(surface_);
  return std::exchange(surface_, nullptr)->finish();
}

render::Image8 Canvas::finish_picture() {
  assert(surface_);
  return std::exchange(surface_, nullptr)->finish_picture();
}

}  // namespace mien::pipeline
