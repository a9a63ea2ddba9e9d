#include "motion/error.h"
#include "pipeline/base/drawing/canvas_surface.h"

namespace mien::pipeline {

namespace {

using FontPointer = std::unique_ptr<PangoFontDescription, Release<pango_font_description_free>>;
using FontOptionsPointer =
    std::unique_ptr<cairo_font_options_t, Release<cairo_font_options_destroy>>;

constexpr const char* font_family = "Noto Sans CJK JP";

/// Points of a length that Pango gives.
double points(int units) { return static_cast<double>(units) / PANGO_SCALE; }

}  // namespace

void Canvas::Surface::set_up_text() {
  // A font map of its own: canvases on different threads share nothing.
  fonts.reset(pango_cairo_font_map_new());
  // One point of text is one point of page, and glyphs are placed as on paper, not on pixels.
  pango_cairo_font_map_set_resolution(PANGO_CAIRO_FONT_MAP(fonts.get()), 72.0);
  const std::unique_ptr<PangoContext, Release<g_object_unref>> text(
      pango_font_map_create_context(fonts.get()));
  const FontOptionsPointer options(cairo_font_options_create());
  cairo_font_options_set_antialias(options.get(), CAIRO_ANTIALIAS_GRAY);
  cairo_font_options_set_hint_style(options.get(), CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options.get(), CAIRO_HINT_METRICS_OFF);
  pango_cairo_context_set_font_options(text.get(), options.get());
  pango_context_set_language(text.get(), pango_language_from_string("en"));
  pango_context_set_round_glyph_positions(text.get(), FALSE);
  pango_cairo_update_context(context.get(), text.get());
  layout.reset(pango_layout_new(text.get()));
  pango_layout_set_single_paragraph_mode(layout.get(), TRUE);
  require_japanese();
}

void Canvas::Surface::require_japanese() const {
  set("速さ 明瞭さ 骨盤 かわいい", {});
  if (pango_layout_get_unknown_glyphs_count(layout.get()) == 0) return;
  throw Error("no font on this machine has Japanese letters", "install fonts-noto-cjk");
}

void Canvas::Surface::set(std::string_view utf8, const TextStyle& style) const {
  const FontPointer font(pango_font_description_from_string(font_family));
  pango_font_description_set_weight(font.get(),
                                    style.bold ? PANGO_WEIGHT_BOLD : PANGO_WEIGHT_NORMAL);
  pango_font_description_set_absolute_size(font.get(), style.size * PANGO_SCALE);
  pango_layout_set_font_description(layout.get(), font.get());
  pango_layout_set_text(layout.get(), utf8.data(), static_cast<int>(utf8.size()));
  const bool limited = style.max_width > 0.0;
  pango_layout_set_ellipsize(layout.get(), limited ? PANGO_ELLIPSIZE_END : PANGO_ELLIPSIZE_NONE);
  pango_layout_set_width(layout.get(),
                         limited ? static_cast<int>(style.max_width * PANGO_SCALE) : -1);
}

Box Canvas::text(Point baseline, std::string_view utf8, const TextStyle& style) {
  surface_->set(utf8, style);
  PangoLayout* layout = surface_->layout.get();
  PangoRectangle ink_box;
  PangoRectangle advance;
  pango_layout_get_extents(layout, &ink_box, &advance);
  double left = baseline.x - points(advance.x);
  if (style.align == Align::centre) left -= 0.5 * points(advance.width);
  if (style.align == Align::right) left -= points(advance.width);
  const double top = baseline.y - points(pango_layout_get_baseline(layout));
  surface_->colour(style.colour);
  cairo_move_to(surface_->context.get(), left, top);
  pango_cairo_show_layout(surface_->context.get(), layout);
  const Box box = {left + points(ink_box.x), top + points(ink_box.y), points(ink_box.width),
                   points(ink_box.height)};
  texts_.push_back({std::string(utf8), box});
  return box;
}

double Canvas::text_width(std::string_view utf8, const TextStyle& style) const {
  TextStyle unlimited = style;
  unlimited.max_width = 0.0;
  surface_->set(utf8, unlimited);
  PangoRectangle advance;
  pango_layout_get_extents(surface_->layout.get(), nullptr, &advance);
  return points(advance.width);
}

}  // namespace mien::pipeline
