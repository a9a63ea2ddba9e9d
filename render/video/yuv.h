#pragma once

#include <cstdint>

#include "render/image/image.h"

namespace mien::render {

/// A picture of 8 bits, BT.709 of limited range, with one pair of colour differences for 2 × 2
/// pixels, placed at the left pixels' column, between their rows (as H.264, VP9 and AV1 have it).
struct Yuv420 {
  int width = 0;   ///< even
  int height = 0;  ///< even
  const std::uint8_t* planes[3] = {};
  int strides[3] = {};  ///< bytes from row to row
};

/// Converts to sRGB codes. Colour differences are interpolated linearly. Whole numbers only, so the
/// same everywhere; within one code of the definition for a flat colour.
///
/// With a step, only of the rows 0, step, 2 · step …
Image8 rgb_from_yuv(const Yuv420& picture, int row_step = 1);

/// Planes for a picture of an even size, to be filled.
struct Yuv420Planes {
  std::uint8_t* planes[3] = {};
  int strides[3] = {};  ///< bytes from row to row
};

/// Converts a picture of an even size to 4:2:0: each code is rounded to the nearest; a colour
/// difference is the mean of two rows, weighted 1 2 1 along them. Whole numbers only, so the same
/// everywhere.
void yuv_from_rgb(const Image8& picture, const Yuv420Planes& out);

}  // namespace mien::render
