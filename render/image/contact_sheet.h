#pragma once

#include <span>
#include <vector>

#include "render/image/image.h"
#include "render/math/vector.h"

namespace mien::render {

/// Returns `count` frame indices spread evenly over 0 … frame_count − 1, both ends included; fewer
/// when there are fewer frames; the middle one when `count` is 1.
std::vector<int> evenly_spread(int frame_count, int count);

struct ContactSheet {
  int columns = 4;  ///< at most
  int gap = 8;      ///< pixels between the pictures and around them
  std::uint8_t background[3] = {255, 255, 255};
};

/// Arranges pictures of the same size row by row from the top left; scale them down first
/// (resize.h). Throws std::invalid_argument when there are none or sizes differ.
Image8 contact_sheet(std::span<const Image8> pictures, const ContactSheet& layout = {});

}  // namespace mien::render
