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

/// Everything that a page of pictures shows.
struct StillsContent {
  std::string study;
  std::string title;          ///< the sheet's id
  std::vector<Still> stills;  ///< at least one, row by row
  int columns = 6;            ///< at least one; a page has no more than it has pictures
  std::vector<std::pair<std::string, std::string>> provenance;
};

/// Widest that a picture stands on a page.
inline constexpr int still_width = 480;

/// A page as large as its pictures need, all of them as wide as the narrowest of them or, if that
/// is less, `still_width` pixels, each above its name. Pictures of other shapes stand in the middle
/// of their place. The PNG shows them pixel by pixel. The same content gives the same bytes. Throws
/// mien::Error when no font has Japanese letters.
std::string stills_as_pdf(const StillsContent& content);
std::string stills_as_png(const StillsContent& content);

}  // namespace mien::pipeline
