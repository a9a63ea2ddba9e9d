#pragma once

#include <string>
#include <utility>
#include <vector>

#include "render/image/image.h"

namespace mien::pipeline {

/// A picture of a stimulus and its name.
struct Still {
  std::string id;
  render::Image8 picture;
};

/// The content of a page of stills.
struct StillsContent {
  std::string study;
  std::string title;          ///< the sheet's id
  std::vector<Still> stills;  ///< at least one, row by row
  int columns = 6;            ///< pictures per row, at least one; limited to the number of pictures
  std::vector<std::pair<std::string, std::string>> provenance;
};

/// Maximum width of a picture on a page, in pixels.
inline constexpr int still_width = 480;

/// Return a page as large as its pictures require. All are scaled to the width of the narrowest, at
/// most `still_width` pixels, and stand above their names. Pictures of less height than the tallest
/// are centred in their cells. The PNG shows them at this size, pixel by pixel. The same content
/// gives the same bytes. Throws mien::Error if no font has Japanese characters.
std::string stills_as_pdf(const StillsContent& content);
std::string stills_as_png(const StillsContent& content);

}  // namespace mien::pipeline
