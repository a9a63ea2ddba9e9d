#pragma once

#include <memory>
#include <string>

#include "pipeline/base/drawing/canvas.h"

namespace mien::pipeline {

// Interface to Pango and Cairo, with which canvases draw. They depend on forty libraries that take
// longer to load than all others together, so they are linked to a module that is loaded when the
// first page is drawn. Program and module share only this type and those of canvas.h.

/// Creates canvases. Thread-safe.
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

/// Loads the libraries on the first call. Throws render::Error if they cannot be loaded.
const PageLibraries& page_libraries();

/// Version of this interface (load_part.h).
inline constexpr int page_libraries_edition = 2;

}  // namespace mien::pipeline
