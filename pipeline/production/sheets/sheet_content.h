#pragma once

#include <string>
#include <utility>
#include <vector>

#include "pipeline/base/drawing/palette.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/production/sheets/sheet.h"
#include "pipeline/production/synthesis/motions.h"

namespace mien::pipeline {

/// The content of a gallery page with many motions, one per row; distances are measured from the
/// first.
struct GalleryContent {
  std::string study;
  std::string title;  ///< the sheet's id
  std::vector<SheetMotion> motions;
  std::vector<double> distances_m;     ///< distance D from the first, one per motion
  std::vector<MotionColours> colours;  ///< colours of the roles, one per motion
  bool simulated_ratings = false;
  std::vector<std::pair<std::string, std::string>> provenance;
};

/// Return a page as wide as A3 landscape and as high as its rows require: for each motion its name
/// and source, its duration, its D from the first, and stick figures at the eleven corresponding
/// times. Throws mien::Error if no font has Japanese characters.
std::string gallery_as_pdf(const GalleryContent& content);
std::string gallery_as_png(const GalleryContent& content);

/// Returns the provenance printed on every sheet: ("seed", "7"), …
std::vector<std::pair<std::string, std::string>> provenance_of(const Manifest& manifest);

/// Returns the source of a motion as sheets state it: "from adjectives", "example". The motion is
/// not made.
std::string origin_of(const std::string& name, const Motions& motions);

/// Returns the content of a comparison sheet of the manifest: makes its motions and measures their
/// distance.
SheetContent sheet_content(const Sheet& sheet, const Manifest& manifest, Motions& motions);

/// Returns the content of a gallery.
GalleryContent gallery_content(const Sheet& sheet, const Manifest& manifest, Motions& motions);

}  // namespace mien::pipeline
