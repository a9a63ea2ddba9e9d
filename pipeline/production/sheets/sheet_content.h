#pragma once

#include "pipeline/manifest/manifest.h"
#include "pipeline/production/sheets/gallery.h"
#include "pipeline/production/sheets/sheet.h"
#include "pipeline/production/synthesis/motions.h"

namespace mien::pipeline {

/// What every sheet says of how it was made: ("seed", "7"), …
std::vector<std::pair<std::string, std::string>> provenance_of(const Manifest& manifest);

/// What a comparison sheet of the manifest shows: makes its motions and measures their distance.
SheetContent sheet_content(const Sheet& sheet, const Manifest& manifest, Motions& motions);

/// What a gallery shows.
GalleryContent gallery_content(const Sheet& sheet, const Manifest& manifest, Motions& motions);

}  // namespace mien::pipeline
