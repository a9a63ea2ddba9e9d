#pragma once

#include "render/image/image.h"

namespace mien::render {

/// A rectangle of pixels, (x, y) its upper left.
struct PicturePart {
  int x = 0, y = 0, width = 0, height = 0;
};

/// What of `part` depends on pixels that differ, when each depends on those up to `reach` pixels
/// about it: the rectangle around all that differ there, and as far about it. Within `part`; of no
/// height when nothing differs. The pictures have one size.
PicturePart changed_part(const Image8& a, const Image8& b, const PicturePart& part, int reach);

}  // namespace mien::render
