#pragma once

#include "render/image/image.h"

namespace mien::render {

/// Returns the picture at another size in pixels, filtered in linear light by a separable
/// Mitchell–Netravali kernel (B = C = 1/3), which is widened if the picture is made smaller; edge
/// pixels are replicated. Throws std::invalid_argument when a size is not positive.
Image8 resized(const Image8& image, int width, int height);

}  // namespace mien::render
