#include "pipeline/base/drawing/canvas.h"

#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <new>
#include <stdexcept>

#include <cairo-pdf.h>
#include <cairo-svg.h>

#include "pipeline/base/drawing/canvas_surface.h"

namespace mien::pipeline {

namespace {

void require(cairo_status_t status) {
  if (status == CAIRO_STATUS_SUCCESS) return;
  throw std::runtime_error(std::string("drawing failed: ") + cairo_status_to_string(status));
}

cairo_status_t append(void* bytes, const unsigned char* chunk, unsigned length) {
  try {
    static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(chunk), length);
  } catch (const std::bad_alloc&) {
    return CAIRO_STATUS_NO_MEMORY;
  }
  return CAIRO_STATUS_SUCCESS;
}

/// Cairo numbers the surfaces of a process and writes the number into the page's group; the same
/// drawing shall be the same bytes.
void name_page(std::string& svg) {
  constexpr std::string_view numbered = "<g id=\"surface";
  const std::size_t start = svg.find(numbered);
  if (start == std::string::npos) return;
  const std::size_t end = svg.find('"', start + numbered.size());
  svg.replace(start, end - start, "<g id=\"page");
}

}  // namespace

void Canvas::Surface::path(const Box& box, double corner_radius) const {
  cairo_t* c = context.get();
  cairo_new_path(c);
  if (corner_radius <= 0.0) {
    cairo_rectangle(c, box.x, box.y, box.width, box.height);
    return;
  }
  const double r = corner_radius;
  cairo_arc(c, box.right() - r, box.y + r, r, -M_PI_2, 0);
  cairo_arc(c, box.right() - r, box.bottom() - r, r, 0, M_PI_2);
  cairo_arc(c, box.x + r, box.bottom() - r, r, M_PI_2, M_PI);
  cairo_arc(c, box.x + r, box.y + r, r, M_PI, 3 * M_PI_2);
  cairo_close_path(c);
}

void Canvas::Surface::colour(const Colour& c, double opacity) const {
  cairo_set_source_rgba(context.get(), c.red, c.green, c.blue, opacity);
}

void Canvas::Surface::stroke(const LineStyle& style) const {
  colour(style.colour);
  cairo_set_line_width(context.get(), style.width);
  const std::array<double, 2> dashes = {2.2 * style.width, 2.2 * style.width};
  cairo_set_dash(context.get(), dashes.data(), style.dashed ? 2 : 0, 0.0);
  cairo_stroke(context.get());
}

Canvas::Canvas(std::unique_ptr<Surface> surface) : surface_(std::move(surface)) {
  surface_->context.reset(cairo_create(surface_->surface.get()));
  require(cairo_status(surface_->context.get()));
  cairo_set_line_cap(surface_->context.get(), CAIRO_LINE_CAP_ROUND);
  cairo_set_line_join(surface_->context.get(), CAIRO_LINE_JOIN_ROUND);
}

Canvas::Canvas(Canvas&&) noexcept = default;
Canvas& Canvas::operator=(Canvas&&) noexcept = default;
Canvas::~Canvas() = default;

Canvas Canvas::pdf(double width, double height, const std::string& title) {
  auto surface = std::make_unique<Surface>();
  surface->surface.reset(
      cairo_pdf_surface_create_for_stream(append, &surface->bytes, width, height));
  cairo_surface_t* page = surface->surface.get();
  cairo_pdf_surface_restrict_to_version(page, CAIRO_PDF_VERSION_1_4);
  cairo_pdf_surface_set_metadata(page, CAIRO_PDF_METADATA_TITLE, title.c_str());
  cairo_pdf_surface_set_metadata(page, CAIRO_PDF_METADATA_CREATOR, "mien");
  // Not a date, so none is written: Cairo would put the time of the run there.
  cairo_pdf_surface_set_metadata(page, CAIRO_PDF_METADATA_CREATE_DATE, "");
  Canvas canvas(std::move(surface));
  canvas.surface_->set_up_text();
  return canvas;
}

Canvas Canvas::svg(double width, double height) {
  auto surface = std::make_unique<Surface>();
  surface->svg = true;
  surface->surface.reset(
      cairo_svg_surface_create_for_stream(append, &surface->bytes, width, height));
  cairo_svg_surface_set_document_unit(surface->surface.get(), CAIRO_SVG_UNIT_PT);
  Canvas canvas(std::move(surface));
  canvas.fill(Box{0, 0, width, height}, paper);
  canvas.surface_->set_up_text();
  return canvas;
}

Canvas Canvas::png(double width, double height, int pixels_wide) {
  const double scale = pixels_wide / width;
  auto surface = std::make_unique<Surface>();
  surface->pixels = true;
  surface->surface.reset(cairo_image_surface_create(CAIRO_FORMAT_RGB24, pixels_wide,
                                                    static_cast<int>(std::lround(height * scale))));
  Canvas canvas(std::move(surface));
  cairo_t* context = canvas.surface_->context.get();
  canvas.surface_->colour(paper);
  cairo_paint(context);
  cairo_scale(context, scale, scale);
  canvas.surface_->set_up_text();
  return canvas;
}

bool overlap(const Box& a, const Box& b) {
  return a.x < b.right() && b.x < a.right() && a.y < b.bottom() && b.y < a.bottom();
}

void Canvas::line(Point from, Point to, const LineStyle& style) {
  const std::array<Point, 2> ends = {from, to};
  polyline(ends, style);
}

void Canvas::polyline(std::span<const Point> points, const LineStyle& style) {
  cairo_new_path(surface_->context.get());
  for (const Point& p : points) cairo_line_to(surface_->context.get(), p.x, p.y);
  surface_->stroke(style);
}

void Canvas::fill(const Box& box, const Colour& colour, double corner_radius) {
  surface_->path(box, corner_radius);
  surface_->colour(colour);
  cairo_fill(surface_->context.get());
}

void Canvas::outline(const Box& box, const LineStyle& style, double corner_radius) {
  surface_->path(box, corner_radius);
  surface_->stroke(style);
}

void Canvas::fill(std::span<const Point> polygon, const Colour& colour, double opacity) {
  cairo_new_path(surface_->context.get());
  for (const Point& p : polygon) cairo_line_to(surface_->context.get(), p.x, p.y);
  cairo_close_path(surface_->context.get());
  surface_->colour(colour, opacity);
  cairo_fill(surface_->context.get());
}

void Canvas::disc(Point centre, double radius, const Colour& colour) {
  cairo_new_path(surface_->context.get());
  cairo_arc(surface_->context.get(), centre.x, centre.y, radius, 0, 2 * M_PI);
  surface_->colour(colour);
  cairo_fill(surface_->context.get());
}

void Canvas::ring(Point centre, double radius, const LineStyle& style) {
  cairo_new_path(surface_->context.get());
  cairo_arc(surface_->context.get(), centre.x, centre.y, radius, 0, 2 * M_PI);
  surface_->stroke(style);
}

void Canvas::picture(const Box& box, const render::Image8& image) {
  const SurfacePointer source(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, image.width, image.height));
  require(cairo_surface_status(source.get()));
  const int stride = cairo_image_surface_get_stride(source.get());
  for (int y = 0; y < image.height; ++y) {
    unsigned char* row =
        cairo_image_surface_get_data(source.get()) + static_cast<std::ptrdiff_t>(y) * stride;
    for (int x = 0; x < image.width; ++x) {
      const std::uint8_t* channels = image.at(x, y);
      const std::uint32_t pixel = std::uint32_t{channels[0]} << 16 |
                                  std::uint32_t{channels[1]} << 8 | std::uint32_t{channels[2]};
      std::memcpy(row + 4 * x, &pixel, 4);
    }
  }
  cairo_surface_mark_dirty(source.get());
  cairo_t* c = surface_->context.get();
  cairo_save(c);
  cairo_translate(c, box.x, box.y);
  cairo_scale(c, box.width / image.width, box.height / image.height);
  cairo_set_source_surface(c, source.get(), 0, 0);
  // The edge fades into nothing otherwise where the picture is scaled.
  cairo_pattern_set_extend(cairo_get_source(c), CAIRO_EXTEND_PAD);
  cairo_new_path(c);
  cairo_rectangle(c, 0, 0, image.width, image.height);
  cairo_fill(c);
  cairo_restore(c);
}

std::string Canvas::finish() {
  assert(surface_);
  cairo_surface_t* page = surface_->surface.get();
  require(cairo_status(surface_->context.get()));
  if (surface_->pixels) {
    cairo_surface_flush(page);
    require(cairo_surface_write_to_png_stream(page, append, &surface_->bytes));
  } else {
    cairo_show_page(surface_->context.get());
  }
  cairo_surface_finish(page);
  require(cairo_surface_status(page));
  std::string bytes = std::move(surface_->bytes);
  if (surface_->svg) name_page(bytes);
  surface_.reset();
  return bytes;
}

render::Image8 Canvas::finish_picture() {
  assert(surface_ && surface_->pixels);
  cairo_surface_t* page = surface_->surface.get();
  require(cairo_status(surface_->context.get()));
  cairo_surface_flush(page);
  render::Image8 picture(cairo_image_surface_get_width(page), cairo_image_surface_get_height(page));
  const int stride = cairo_image_surface_get_stride(page);
  for (int y = 0; y < picture.height; ++y) {
    const unsigned char* row =
        cairo_image_surface_get_data(page) + static_cast<std::ptrdiff_t>(y) * stride;
    for (int x = 0; x < picture.width; ++x) {
      std::uint32_t pixel = 0;  // 0x00RRGGBB in the machine's order
      std::memcpy(&pixel, row + 4 * x, 4);
      std::uint8_t* channels = picture.at(x, y);
      channels[0] = static_cast<std::uint8_t>(pixel >> 16);
      channels[1] = static_cast<std::uint8_t>(pixel >> 8);
      channels[2] = static_cast<std::uint8_t>(pixel);
    }
  }
  surface_.reset();
  return picture;
}

}  // namespace mien::pipeline
