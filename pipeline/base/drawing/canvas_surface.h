#pragma once

#include <memory>
#include <string>
#include <string_view>

#include <cairo.h>
#include <pango/pangocairo.h>

#include "pipeline/base/drawing/canvas.h"

namespace mien::pipeline {

// What a canvas is made of; only its own sources include this.

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

struct Canvas::Surface {
  std::string bytes;  // first, so that it outlives the surface that writes to it
  bool pixels = false;
  bool svg = false;
  SurfacePointer surface;
  ContextPointer context;
  FontMapPointer fonts;
  LayoutPointer layout;

  void set_up_text();
  void require_japanese() const;
  void set(std::string_view utf8, const TextStyle& style) const;
  void path(const Box& box, double corner_radius) const;
  void colour(const Colour& c, double opacity = 1.0) const;
  void stroke(const LineStyle& style) const;
};

}  // namespace mien::pipeline
