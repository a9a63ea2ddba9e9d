#pragma once

#include <array>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/base/drawing/palette.h"
#include "render/image/image.h"

namespace mien::pipeline {

/// Positions on a page: points (1/72 inch) from the top left corner, y downwards.
struct Point {
  double x = 0.0;
  double y = 0.0;
};

/// A rectangle on a page, points.
struct Box {
  double x = 0.0;
  double y = 0.0;
  double width = 0.0;
  double height = 0.0;

  double right() const { return x + width; }
  double bottom() const { return y + height; }
  double middle() const { return y + 0.5 * height; }
};

bool overlap(const Box& a, const Box& b);

enum class Align { left, centre, right };

struct TextStyle {
  double size = 8.0;  ///< points
  Colour colour = ink;
  bool bold = false;
  Align align = Align::left;
  double max_width = 0.0;  ///< points; longer text ends in "…"; 0 for no limit
};

struct LineStyle {
  double width = 1.0;  ///< points
  Colour colour = ink;
  bool dashed = false;
};

/// Drawn text and its ink bounding box.
struct DrawnText {
  std::string text;  ///< before shortening to TextStyle::max_width
  Box box;
};

/// A page to draw on, as PDF (vector, text stays text), as SVG (vector, text as outlines, so that
/// it looks the same without our fonts) or as pixels. Line ends and corners are round.
///
/// Text is set in Noto Sans CJK JP; glyphs that it lacks are taken from other system fonts. The
/// same drawing gives the same bytes on every run: no dates or machine names are written.
class Canvas {
 public:
  /// A PDF page. Throws mien::Error when the system's fonts have no Japanese and render::Error
  /// when the part of mien that draws pages cannot be loaded.
  static std::unique_ptr<Canvas> pdf(double width, double height, const std::string& title);
  /// An SVG image. Throws as `pdf`.
  static std::unique_ptr<Canvas> svg(double width, double height);
  /// An image `pixels_wide` wide of a page of the given size in points. Throws as `pdf`.
  static std::unique_ptr<Canvas> png(double width, double height, int pixels_wide);

  virtual ~Canvas() = default;

  void line(Point from, Point to, const LineStyle& style) { polyline(std::array{from, to}, style); }
  virtual void polyline(std::span<const Point> points, const LineStyle& style) = 0;
  virtual void fill(const Box& box, const Colour& colour, double corner_radius = 0.0) = 0;
  virtual void outline(const Box& box, const LineStyle& style, double corner_radius = 0.0) = 0;
  virtual void fill(std::span<const Point> polygon, const Colour& colour, double opacity = 1.0) = 0;
  virtual void disc(Point centre, double radius, const Colour& colour) = 0;
  virtual void ring(Point centre, double radius, const LineStyle& style) = 0;

  /// Draws a picture that fills the box. It is not resampled if its pixels coincide with those of
  /// the page.
  virtual void picture(const Box& box, const render::Image8& image) = 0;

  /// Draws text whose baseline begins, is centred or ends at `baseline` (TextStyle::align), and
  /// returns its ink bounding box.
  Box text(Point baseline, std::string_view utf8, const TextStyle& style) {
    texts_.push_back({std::string(utf8), draw_text(baseline, utf8, style)});
    return texts_.back().box;
  }

  /// Advance width of a text, points; not shortened.
  virtual double text_width(std::string_view utf8, const TextStyle& style) const = 0;

  /// All text drawn so far.
  const std::vector<DrawnText>& texts() const { return texts_; }

  /// Ends the page and returns the file's bytes. The canvas cannot be used afterwards.
  virtual std::string finish() = 0;

  /// Ends a page of pixels and returns them as an image. The canvas cannot be used afterwards.
  virtual render::Image8 finish_picture() = 0;

 private:
  virtual Box draw_text(Point baseline, std::string_view utf8, const TextStyle& style) = 0;

  std::vector<DrawnText> texts_;
};

}  // namespace mien::pipeline
