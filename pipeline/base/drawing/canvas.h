#pragma once

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

/// Text that was drawn, and the box of its ink.
struct DrawnText {
  std::string text;
  Box box;
};

class CanvasSurface;

/// A page to draw on, as PDF (vector, text stays text), as SVG (vector, text as outlines, so that
/// it looks the same without our fonts) or as pixels. Lines and corners are round.
///
/// Text is set in Noto Sans CJK JP; glyphs it lacks come from the fonts that the system offers. The
/// same drawing gives the same bytes on every run: no dates, no names of the machine.
class Canvas {
 public:
  /// A PDF page. Throws mien::Error when the system's fonts have no Japanese and render::Error
  /// when the part of mien that draws pages cannot be loaded.
  static Canvas pdf(double width, double height, const std::string& title);
  /// An SVG image. Throws as `pdf`.
  static Canvas svg(double width, double height);
  /// An image `pixels_wide` wide of a page of the given size in points. Throws as `pdf`.
  static Canvas png(double width, double height, int pixels_wide);

  Canvas(Canvas&&) noexcept;
  Canvas& operator=(Canvas&&) noexcept;
  ~Canvas();

  void line(Point from, Point to, const LineStyle& style);
  void polyline(std::span<const Point> points, const LineStyle& style);
  void fill(const Box& box, const Colour& colour, double corner_radius = 0.0);
  void outline(const Box& box, const LineStyle& style, double corner_radius = 0.0);
  void fill(std::span<const Point> polygon, const Colour& colour, double opacity = 1.0);
  void disc(Point centre, double radius, const Colour& colour);
  void ring(Point centre, double radius, const LineStyle& style);

  /// A picture that fills the box. Pixels stay pixels where one falls on one.
  void picture(const Box& box, const render::Image8& image);

  /// Sets text with its baseline at `baseline` and returns the box of its ink.
  Box text(Point baseline, std::string_view utf8, const TextStyle& style);

  /// Advance width of a text, points; not shortened.
  double text_width(std::string_view utf8, const TextStyle& style) const;

  /// All text drawn so far.
  const std::vector<DrawnText>& texts() const { return texts_; }

  /// Ends the page and returns the file's bytes. The canvas is used up.
  std::string finish();

  /// Ends a page of pixels and returns them instead. The canvas is used up.
  render::Image8 finish_picture();

 private:
  explicit Canvas(std::unique_ptr<CanvasSurface> surface);

  std::unique_ptr<CanvasSurface> surface_;
  std::vector<DrawnText> texts_;
};

}  // namespace mien::pipeline
