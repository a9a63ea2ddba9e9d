#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "pipeline/base/drawing/canvas.h"

namespace mien::pipeline {

// What a canvas draws with: Pango and Cairo. They bring forty libraries, which take longer to load
// than all else that mien is linked to, and so lie in a part of the program that is loaded when the
// first page is drawn. These types and those of canvas.h are all that both sides know.

/// As the functions of Canvas.
class CanvasSurface {
 public:
  virtual ~CanvasSurface() = default;
  virtual void polyline(std::span<const Point> points, const LineStyle& style) = 0;
  virtual void fill(const Box& box, const Colour& colour, double corner_radius) = 0;
  virtual void outline(const Box& box, const LineStyle& style, double corner_radius) = 0;
  virtual void fill(std::span<const Point> polygon, const Colour& colour, double opacity) = 0;
  virtual void disc(Point centre, double radius, const Colour& colour) = 0;
  virtual void ring(Point centre, double radius, const LineStyle& style) = 0;
  virtual void picture(const Box& box, const render::Image8& image) = 0;
  virtual Box text(Point baseline, std::string_view utf8, const TextStyle& style) = 0;
  virtual double text_width(std::string_view utf8, const TextStyle& style) const = 0;
  virtual std::string finish() = 0;
  virtual render::Image8 finish_picture() = 0;
};

/// The libraries. For several threads.
class PageLibraries {
 public:
  virtual ~PageLibraries() = default;
  virtual std::unique_ptr<CanvasSurface> pdf(double width, double height,
                                             const std::string& title) const = 0;
  virtual std::unique_ptr<CanvasSurface> svg(double width, double height) const = 0;
  virtual std::unique_ptr<CanvasSurface> png(double width, double height,
                                             int pixels_wide) const = 0;
  virtual std::string cairo_version() const = 0;  ///< "1.16.0"
  virtual std::string pango_version() const = 0;
};

/// The libraries, loaded when this is first called. Throws render::Error when they are not there.
const PageLibraries& page_libraries();

/// Of the types above (loaded_part.h).
inline constexpr int page_libraries_edition = 1;

}  // namespace mien::pipeline
