#pragma once

#include "pipeline/gallery.h"
#include "pipeline/manifest.h"
#include "pipeline/motions.h"
#include "pipeline/sheet.h"

namespace mien::pipeline {

/// What a comparison sheet of the manifest shows: makes its motions and measures their distance.
SheetContent sheet_content(const Sheet& sheet, const Manifest& manifest, Motions& motions);

/// What a gallery shows.
GalleryContent gallery_content(const Sheet& sheet, const Manifest& manifest, Motions& motions);

}  // namespace mien::pipeline
