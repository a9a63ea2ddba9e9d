// The part of the program that is linked to Pango and Cairo (pango_calls.cpp): with it come all
// their functions.

#include <cairo.h>
#include <pango/pangocairo.h>

extern "C" {
/// One function of each, so that each is linked.
extern const void* const mien_page_libraries[];
const void* const mien_page_libraries[] = {reinterpret_cast<const void*>(cairo_version_string),
                                           reinterpret_cast<const void*>(pango_version_string),
                                           reinterpret_cast<const void*>(pango_cairo_font_map_new),
                                           reinterpret_cast<const void*>(g_object_unref)};
}
