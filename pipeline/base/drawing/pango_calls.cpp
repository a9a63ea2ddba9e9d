// Pango and Cairo bring forty libraries, which take longer to load than all else that mien is
// linked to. So mien is not linked to them: here are those of their functions that it calls, and
// the part that is linked is pango_part.cpp.

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <pango/pangocairo.h>

#include "render/parts/library_calls.h"

namespace mien::pipeline {

namespace {

struct Pages {
  static const char* name() { return "mien-pages.so"; }
  static const char* purpose() { return "draws sheets and charts"; }
};

}  // namespace

}  // namespace mien::pipeline

#define MIEN_PANGO(result, name, parameters, arguments) \
  MIEN_LIBRARY_CALL(mien::pipeline::Pages, result, name, parameters, arguments)

// clang-format off
extern "C" {
MIEN_PANGO(void, cairo_arc, (cairo_t* a, double b, double c, double d, double e, double f),
           (a, b, c, d, e, f))
MIEN_PANGO(void, cairo_close_path, (cairo_t* a), (a))
MIEN_PANGO(cairo_t*, cairo_create, (cairo_surface_t* a), (a))
MIEN_PANGO(void, cairo_destroy, (cairo_t* a), (a))
MIEN_PANGO(void, cairo_fill, (cairo_t* a), (a))
MIEN_PANGO(cairo_font_options_t*, cairo_font_options_create, (), ())
MIEN_PANGO(void, cairo_font_options_destroy, (cairo_font_options_t* a), (a))
MIEN_PANGO(void, cairo_font_options_set_antialias, (cairo_font_options_t* a, cairo_antialias_t b),
           (a, b))
MIEN_PANGO(void, cairo_font_options_set_hint_metrics, (cairo_font_options_t* a,
            cairo_hint_metrics_t b), (a, b))
MIEN_PANGO(void, cairo_font_options_set_hint_style, (cairo_font_options_t* a, cairo_hint_style_t b),
           (a, b))
MIEN_PANGO(cairo_pattern_t*, cairo_get_source, (cairo_t* a), (a))
MIEN_PANGO(cairo_surface_t*, cairo_image_surface_create, (cairo_format_t a, int b, int c),
           (a, b, c))
MIEN_PANGO(unsigned char*, cairo_image_surface_get_data, (cairo_surface_t* a), (a))
MIEN_PANGO(int, cairo_image_surface_get_height, (cairo_surface_t* a), (a))
MIEN_PANGO(int, cairo_image_surface_get_stride, (cairo_surface_t* a), (a))
MIEN_PANGO(int, cairo_image_surface_get_width, (cairo_surface_t* a), (a))
MIEN_PANGO(void, cairo_line_to, (cairo_t* a, double b, double c), (a, b, c))
MIEN_PANGO(void, cairo_move_to, (cairo_t* a, double b, double c), (a, b, c))
MIEN_PANGO(void, cairo_new_path, (cairo_t* a), (a))
MIEN_PANGO(void, cairo_paint, (cairo_t* a), (a))
MIEN_PANGO(void, cairo_pattern_set_extend, (cairo_pattern_t* a, cairo_extend_t b), (a, b))
MIEN_PANGO(cairo_surface_t*, cairo_pdf_surface_create_for_stream, (cairo_write_func_t a, void* b,
            double c, double d), (a, b, c, d))
MIEN_PANGO(void, cairo_pdf_surface_restrict_to_version, (cairo_surface_t* a, cairo_pdf_version_t b),
           (a, b))
MIEN_PANGO(void, cairo_pdf_surface_set_metadata, (cairo_surface_t* a, cairo_pdf_metadata_t b,
            const char* c), (a, b, c))
MIEN_PANGO(void, cairo_rectangle, (cairo_t* a, double b, double c, double d, double e),
           (a, b, c, d, e))
MIEN_PANGO(void, cairo_restore, (cairo_t* a), (a))
MIEN_PANGO(void, cairo_save, (cairo_t* a), (a))
MIEN_PANGO(void, cairo_scale, (cairo_t* a, double b, double c), (a, b, c))
MIEN_PANGO(void, cairo_set_dash, (cairo_t* a, const double* b, int c, double d), (a, b, c, d))
MIEN_PANGO(void, cairo_set_line_cap, (cairo_t* a, cairo_line_cap_t b), (a, b))
MIEN_PANGO(void, cairo_set_line_join, (cairo_t* a, cairo_line_join_t b), (a, b))
MIEN_PANGO(void, cairo_set_line_width, (cairo_t* a, double b), (a, b))
MIEN_PANGO(void, cairo_set_source_rgba, (cairo_t* a, double b, double c, double d, double e),
           (a, b, c, d, e))
MIEN_PANGO(void, cairo_set_source_surface, (cairo_t* a, cairo_surface_t* b, double c, double d),
           (a, b, c, d))
MIEN_PANGO(void, cairo_show_page, (cairo_t* a), (a))
MIEN_PANGO(cairo_status_t, cairo_status, (cairo_t* a), (a))
MIEN_PANGO(const char*, cairo_status_to_string, (cairo_status_t a), (a))
MIEN_PANGO(void, cairo_stroke, (cairo_t* a), (a))
MIEN_PANGO(void, cairo_surface_destroy, (cairo_surface_t* a), (a))
MIEN_PANGO(void, cairo_surface_finish, (cairo_surface_t* a), (a))
MIEN_PANGO(void, cairo_surface_flush, (cairo_surface_t* a), (a))
MIEN_PANGO(void, cairo_surface_mark_dirty, (cairo_surface_t* a), (a))
MIEN_PANGO(cairo_status_t, cairo_surface_status, (cairo_surface_t* a), (a))
MIEN_PANGO(cairo_status_t, cairo_surface_write_to_png_stream, (cairo_surface_t* a,
            cairo_write_func_t b, void* c), (a, b, c))
MIEN_PANGO(cairo_surface_t*, cairo_svg_surface_create_for_stream, (cairo_write_func_t a, void* b,
            double c, double d), (a, b, c, d))
MIEN_PANGO(void, cairo_svg_surface_set_document_unit, (cairo_surface_t* a, cairo_svg_unit_t b),
           (a, b))
MIEN_PANGO(void, cairo_translate, (cairo_t* a, double b, double c), (a, b, c))
MIEN_PANGO(const char*, cairo_version_string, (), ())
MIEN_PANGO(void, g_object_unref, (gpointer a), (a))
MIEN_PANGO(GTypeInstance*, g_type_check_instance_cast, (GTypeInstance* a, GType b), (a, b))
MIEN_PANGO(void, pango_cairo_context_set_font_options, (PangoContext* a,
            const cairo_font_options_t* b), (a, b))
MIEN_PANGO(GType, pango_cairo_font_map_get_type, (), ())
MIEN_PANGO(PangoFontMap*, pango_cairo_font_map_new, (), ())
MIEN_PANGO(void, pango_cairo_font_map_set_resolution, (PangoCairoFontMap* a, double b), (a, b))
MIEN_PANGO(void, pango_cairo_show_layout, (cairo_t* a, PangoLayout* b), (a, b))
MIEN_PANGO(void, pango_cairo_update_context, (cairo_t* a, PangoContext* b), (a, b))
MIEN_PANGO(void, pango_context_set_language, (PangoContext* a, PangoLanguage* b), (a, b))
MIEN_PANGO(void, pango_context_set_round_glyph_positions, (PangoContext* a, gboolean b), (a, b))
MIEN_PANGO(void, pango_font_description_free, (PangoFontDescription* a), (a))
MIEN_PANGO(PangoFontDescription*, pango_font_description_from_string, (const char* a), (a))
MIEN_PANGO(void, pango_font_description_set_absolute_size, (PangoFontDescription* a, double b),
           (a, b))
MIEN_PANGO(void, pango_font_description_set_weight, (PangoFontDescription* a, PangoWeight b),
           (a, b))
MIEN_PANGO(PangoContext*, pango_font_map_create_context, (PangoFontMap* a), (a))
MIEN_PANGO(PangoLanguage*, pango_language_from_string, (const char* a), (a))
MIEN_PANGO(int, pango_layout_get_baseline, (PangoLayout* a), (a))
MIEN_PANGO(void, pango_layout_get_extents, (PangoLayout* a, PangoRectangle* b, PangoRectangle* c),
           (a, b, c))
MIEN_PANGO(int, pango_layout_get_unknown_glyphs_count, (PangoLayout* a), (a))
MIEN_PANGO(PangoLayout*, pango_layout_new, (PangoContext* a), (a))
MIEN_PANGO(void, pango_layout_set_ellipsize, (PangoLayout* a, PangoEllipsizeMode b), (a, b))
MIEN_PANGO(void, pango_layout_set_font_description, (PangoLayout* a, const PangoFontDescription* b),
           (a, b))
MIEN_PANGO(void, pango_layout_set_single_paragraph_mode, (PangoLayout* a, gboolean b), (a, b))
MIEN_PANGO(void, pango_layout_set_text, (PangoLayout* a, const char* b, int c), (a, b, c))
MIEN_PANGO(void, pango_layout_set_width, (PangoLayout* a, int b), (a, b))
MIEN_PANGO(const char*, pango_version_string, (), ())
}
// clang-format on

#undef MIEN_PANGO
