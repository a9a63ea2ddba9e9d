#pragma once

#include "render/image/image.h"

namespace mien::render {

/// The picture at another size, filtered in linear light by a separable Mitchell–Netravali kernel
/// (B = C = 1/3) as wide as the scale asks, edges repeated. Throws std::invalid_argument when a
/// size is not positive.
Image8 resized(const Image8& image, int width, int height);

}  // namespace mien::render
