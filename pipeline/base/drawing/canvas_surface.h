#pragma once

#include <memory>
#include <string>

#include "pipeline/base/drawing/canvas.h"

namespace mien::pipeline {

// What a canvas draws with: Pango and Cairo. They bring forty libraries, which take longer to load
// than all else that mien is linked to, and so lie in a part of the program that is loaded when the
// first page is drawn. This type and those of canvas.h are all that both sides know.

/// The libraries. For several threads.
class PageLibraries {
 public:
  virtual ~PageLibraries() = default;
  virtual std::unique_ptr<Canvas> pdf(double width, double height,
                                      const std::string& title) const = 0;
  virtual std::unique_ptr<Canvas> svg(double width, double height) const = 0;
  virtual std::unique_ptr<Canvas> png(double width, double height, int pixels_wide) const = 0;
  virtual std::string cairo_version() const = 0;  ///< "1.16.0"
  virtual std::string pango_version() const = 0;
};

/// The libraries, loaded when this is first called. Throws render::Error when they are not there.
const PageLibraries& page_libraries();

/// Of these types (load_part.h).
inline constexpr int page_libraries_edition = 2;

}  // namespace mien::pipeline
