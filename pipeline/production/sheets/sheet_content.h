#pragma once

#include <string>
#include <utility>
#include <vector>

#include "pipeline/base/drawing/palette.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/production/sheets/sheet.h"
#include "pipeline/production/synthesis/motions.h"

namespace mien::pipeline {

/// Everything that a page with many motions shows, one a row; the first is what the others are
/// measured against.
struct GalleryContent {
  std::string study;
  std::string title;  ///< the sheet's id
  std::vector<SheetMotion> motions;
  std::vector<double> distances_m;     ///< D from the first, one a motion
  std::vector<MotionColours> colours;  ///< one a motion: of its role
  bool simulated_ratings = false;
  std::vector<std::pair<std::string, std::string>> provenance;
};

/// A page as wide as A3 landscape and as high as its rows need: of every motion its name and
/// origin, duration and D from the first, and stick figures at the eleven
/// corresponding times. Throws mien::Error when no font has Japanese letters.
std::string gallery_as_pdf(const GalleryContent& content);
std::string gallery_as_png(const GalleryContent& content);

/// What every sheet says of how it was made: ("seed", "7"), …
std::vector<std::pair<std::string, std::string>> provenance_of(const Manifest& manifest);

/// What a comparison sheet of the manifest shows: makes its motions and measures their distance.
SheetContent sheet_content(const Sheet& sheet, const Manifest& manifest, Motions& motions);

/// What a gallery shows.
GalleryContent gallery_content(const Sheet& sheet, const Manifest& manifest, Motions& motions);

}  // namespace mien::pipeline
