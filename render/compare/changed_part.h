#pragma once

#include "render/image/image.h"

namespace mien::render {

/// A rectangle of pixels, (x, y) its upper left.
struct PicturePart {
  int x = 0, y = 0, width = 0, height = 0;
};

/// The rectangle within `part` whose results can differ if each depends on the pixels up to `reach`
/// around it: the bounding box of the differing pixels, grown by `reach`. Its height is 0 when
/// nothing differs. Both pictures have one size.
PicturePart changed_part(const Image8& a, const Image8& b, const PicturePart& part, int reach);

}  // namespace mien::render
