// The part of the program that is linked to Pango and Cairo.

#include "pipeline/base/drawing/canvas_surface.h"

#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <new>
#include <stdexcept>

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <pango/pangocairo.h>

#include "motion/error.h"

namespace mien::pipeline {

namespace {

template <auto release>
struct Release {
  template <typename T>
  void operator()(T* resource) const {
    release(resource);
  }
};

using SurfacePointer = std::unique_ptr<cairo_surface_t, Release<cairo_surface_destroy>>;
using ContextPointer = std::unique_ptr<cairo_t, Release<cairo_destroy>>;
using FontMapPointer = std::unique_ptr<PangoFontMap, Release<g_object_unref>>;
using LayoutPointer = std::unique_ptr<PangoLayout, Release<g_object_unref>>;

using FontPointer = std::unique_ptr<PangoFontDescription, Release<pango_font_description_free>>;
using FontOptionsPointer =
    std::unique_ptr<cairo_font_options_t, Release<cairo_font_options_destroy>>;

constexpr const char* font_family = "Noto Sans CJK JP";

/// Points of a length that Pango gives.
double points(int units) { return static_cast<double>(units) / PANGO_SCALE; }

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
/// drawing must give the same bytes.
void name_page(std::string& svg) {
  constexpr std::string_view numbered = "<g id=\"surface";
  const std::size_t start = svg.find(numbered);
  if (start == std::string::npos) return;
  const std::size_t end = svg.find('"', start + numbered.size());
  svg.replace(start, end - start, "<g id=\"page");
}

class CairoCanvas final : public Canvas {
 public:
  static std::unique_ptr<Canvas> pdf(double width, double height, const std::string& title) {
    auto page = std::make_unique<CairoCanvas>();
    cairo_surface_t* surface =
        cairo_pdf_surface_create_for_stream(append, &page->bytes_, width, height);
    cairo_pdf_surface_restrict_to_version(surface, CAIRO_PDF_VERSION_1_4);
    cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_TITLE, title.c_str());
    cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATOR, "mien");
    // Not a date, so none is written: Cairo would put the time of the run there.
    cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE, "");
    page->draw_on(surface);
    page->set_up_text();
    return page;
  }

  static std::unique_ptr<Canvas> svg(double width, double height) {
    auto page = std::make_unique<CairoCanvas>();
    page->is_svg_ = true;
    cairo_surface_t* surface =
        cairo_svg_surface_create_for_stream(append, &page->bytes_, width, height);
    cairo_svg_surface_set_document_unit(surface, CAIRO_SVG_UNIT_PT);
    page->draw_on(surface);
    page->fill(Box{0, 0, width, height}, paper, 0.0);
    page->set_up_text();
    return page;
  }

  static std::unique_ptr<Canvas> png(double width, double height, int pixels_wide) {
    const double scale = pixels_wide / width;
    auto page = std::make_unique<CairoCanvas>();
    page->is_pixels_ = true;
    page->draw_on(cairo_image_surface_create(CAIRO_FORMAT_RGB24, pixels_wide,
                                             static_cast<int>(std::lround(height * scale))));
    page->draw_in(paper);
    cairo_paint(page->context_.get());
    cairo_scale(page->context_.get(), scale, scale);
    page->set_up_text();
    return page;
  }

  void polyline(std::span<const Point> points, const LineStyle& style) override {
    path(points);
    stroke(style);
  }

  void fill(const Box& box, const Colour& colour, double corner_radius) override {
    path(box, corner_radius);
    draw_in(colour);
    cairo_fill(context_.get());
  }

  void fill(std::span<const Point> polygon, const Colour& colour, double opacity) override {
    path(polygon);
    cairo_close_path(context_.get());
    draw_in(colour, opacity);
    cairo_fill(context_.get());
  }

  void outline(const Box& box, const LineStyle& style, double corner_radius) override {
    path(box, corner_radius);
    stroke(style);
  }

  void disc(Point centre, double radius, const Colour& colour) override {
    circle(centre, radius);
    draw_in(colour);
    cairo_fill(context_.get());
  }

  void ring(Point centre, double radius, const LineStyle& style) override {
    circle(centre, radius);
    stroke(style);
  }

  void picture(const Box& box, const render::Image8& image) override {
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
    cairo_t* c = context_.get();
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

  double text_width(std::string_view utf8, const TextStyle& style) const override {
    TextStyle unlimited = style;
    unlimited.max_width = 0.0;
    set(utf8, unlimited);
    PangoRectangle advance;
    pango_layout_get_extents(layout_.get(), nullptr, &advance);
    return points(advance.width);
  }

  std::string finish() override {
    cairo_surface_t* page = surface_.get();
    require(cairo_status(context_.get()));
    if (is_pixels_) {
      cairo_surface_flush(page);
      require(cairo_surface_write_to_png_stream(page, append, &bytes_));
    } else {
      cairo_show_page(context_.get());
    }
    cairo_surface_finish(page);
    require(cairo_surface_status(page));
    std::string bytes = std::move(bytes_);
    if (is_svg_) name_page(bytes);
    return bytes;
  }

  render::Image8 finish_picture() override {
    assert(is_pixels_);
    cairo_surface_t* page = surface_.get();
    require(cairo_status(context_.get()));
    cairo_surface_flush(page);
    render::Image8 picture(cairo_image_surface_get_width(page),
                           cairo_image_surface_get_height(page));
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
    return picture;
  }

 private:
  Box draw_text(Point baseline, std::string_view utf8, const TextStyle& style) override {
    set(utf8, style);
    PangoRectangle ink_box;
    PangoRectangle advance;
    pango_layout_get_extents(layout_.get(), &ink_box, &advance);
    double left = baseline.x - points(advance.x);
    if (style.align == Align::centre) left -= 0.5 * points(advance.width);
    if (style.align == Align::right) left -= points(advance.width);
    const double top = baseline.y - points(pango_layout_get_baseline(layout_.get()));
    draw_in(style.colour);
    cairo_move_to(context_.get(), left, top);
    pango_cairo_show_layout(context_.get(), layout_.get());
    return {left + points(ink_box.x), top + points(ink_box.y), points(ink_box.width),
            points(ink_box.height)};
  }

  void draw_on(cairo_surface_t* surface) {
    surface_.reset(surface);
    context_.reset(cairo_create(surface));
    require(cairo_status(context_.get()));
    cairo_set_line_cap(context_.get(), CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(context_.get(), CAIRO_LINE_JOIN_ROUND);
  }

  void set_up_text() {
    // A font map of its own: canvases on different threads share nothing.
    fonts_.reset(pango_cairo_font_map_new());
    // One point of text is one point of page, and glyphs are placed as on paper, not on pixels.
    pango_cairo_font_map_set_resolution(PANGO_CAIRO_FONT_MAP(fonts_.get()), 72.0);
    const std::unique_ptr<PangoContext, Release<g_object_unref>> text(
        pango_font_map_create_context(fonts_.get()));
    const FontOptionsPointer options(cairo_font_options_create());
    cairo_font_options_set_antialias(options.get(), CAIRO_ANTIALIAS_GRAY);
    cairo_font_options_set_hint_style(options.get(), CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options.get(), CAIRO_HINT_METRICS_OFF);
    pango_cairo_context_set_font_options(text.get(), options.get());
    pango_context_set_language(text.get(), pango_language_from_string("en"));
    pango_context_set_round_glyph_positions(text.get(), FALSE);
    pango_cairo_update_context(context_.get(), text.get());
    layout_.reset(pango_layout_new(text.get()));
    pango_layout_set_single_paragraph_mode(layout_.get(), TRUE);
    require_japanese();
  }

  void require_japanese() const {
    set("速さ 明瞭さ 骨盤 かわいい", {});
    if (pango_layout_get_unknown_glyphs_count(layout_.get()) == 0) return;
    throw Error("no font on this machine has Japanese characters", "install fonts-noto-cjk");
  }

  void set(std::string_view utf8, const TextStyle& style) const {
    const FontPointer font(pango_font_description_from_string(font_family));
    pango_font_description_set_weight(font.get(),
                                      style.bold ? PANGO_WEIGHT_BOLD : PANGO_WEIGHT_NORMAL);
    pango_font_description_set_absolute_size(font.get(), style.size * PANGO_SCALE);
    pango_layout_set_font_description(layout_.get(), font.get());
    pango_layout_set_text(layout_.get(), utf8.data(), static_cast<int>(utf8.size()));
    const bool limited = style.max_width > 0.0;
    pango_layout_set_ellipsize(layout_.get(), limited ? PANGO_ELLIPSIZE_END : PANGO_ELLIPSIZE_NONE);
    pango_layout_set_width(layout_.get(),
                           limited ? static_cast<int>(style.max_width * PANGO_SCALE) : -1);
  }

  void path(const Box& box, double corner_radius) const {
    cairo_t* c = context_.get();
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

  void path(std::span<const Point> points) const {
    cairo_new_path(context_.get());
    for (const Point& p : points) cairo_line_to(context_.get(), p.x, p.y);
  }

  void circle(Point centre, double radius) const {
    cairo_new_path(context_.get());
    cairo_arc(context_.get(), centre.x, centre.y, radius, 0, 2 * M_PI);
  }

  void draw_in(const Colour& colour, double opacity = 1.0) const {
    cairo_set_source_rgba(context_.get(), colour.red, colour.green, colour.blue, opacity);
  }

  void stroke(const LineStyle& style) const {
    draw_in(style.colour);
    cairo_set_line_width(context_.get(), style.width);
    const std::array<double, 2> dashes = {2.2 * style.width, 2.2 * style.width};
    cairo_set_dash(context_.get(), dashes.data(), style.dashed ? 2 : 0, 0.0);
    cairo_stroke(context_.get());
  }

  std::string bytes_;  // first, so that it outlives the surface that writes to it
  bool is_pixels_ = false;
  bool is_svg_ = false;
  SurfacePointer surface_;
  ContextPointer context_;
  FontMapPointer fonts_;
  LayoutPointer layout_;
};

class CairoAndPango final : public PageLibraries {
 public:
  std::unique_ptr<Canvas> pdf(double width, double height,
                              const std::string& title) const override {
    return CairoCanvas::pdf(width, height, title);
  }
  std::unique_ptr<Canvas> svg(double width, double height) const override {
    return CairoCanvas::svg(width, height);
  }
  std::unique_ptr<Canvas> png(double width, double height, int pixels_wide) const override {
    return CairoCanvas::png(width, height, pixels_wide);
  }
  std::string cairo_version() const override { return cairo_version_string(); }
  std::string pango_version() const override { return pango_version_string(); }
};

}  // namespace

extern "C" const void* mien_part(int edition) {
  static const CairoAndPango libraries;
  return edition == page_libraries_edition ? static_cast<const PageLibraries*>(&libraries)
                                           : nullptr;
}

}  // namespace mien::pipeline
