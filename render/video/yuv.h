#pragma once

#include <cstdint>

#include "render/image/image.h"

namespace mien::render {

/// An 8-bit 4:2:0 picture, limited-range BT.709. Each pair of colour differences covers 2 × 2
/// pixels and is sited at the left pixels' column, between their rows (as in H.264, VP9 and AV1).
struct Yuv420 {
  int width = 0;   ///< even
  int height = 0;  ///< even
  const std::uint8_t* planes[3] = {};
  int strides[3] = {};  ///< bytes from row to row
};

/// Converts a picture to sRGB code values. Colour differences are interpolated linearly. Uses
/// integer arithmetic only, so results are the same on every machine; for a flat colour they are
/// within one code value of the definition.
///
/// With a `row_step` above 1, only the rows 0, row_step, 2 · row_step … are converted.
Image8 rgb_from_yuv(const Yuv420& picture, int row_step = 1);

/// Planes for a picture of an even size, to be filled.
struct Yuv420Planes {
  std::uint8_t* planes[3] = {};
  int strides[3] = {};  ///< bytes from row to row
};

/// Converts a picture of an even size to 4:2:0, rounding to the nearest code value. A colour
/// difference is the mean of two rows, each weighted 1 2 1 horizontally. Uses integer arithmetic
/// only, so results are the same on every machine.
void yuv_from_rgb(const Image8& picture, const Yuv420Planes& out);

}  // namespace mien::render
