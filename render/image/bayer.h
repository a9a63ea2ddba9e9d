#pragma once

namespace mien::render {

/// The entry, 0 … 63, of the 8 × 8 ordered-dither matrix (Bayer 1973) for a pixel.
constexpr int bayer(int x, int y) {
  int rank = 0;
  for (int bit = 0; bit < 3; ++bit) {
    const int across = ((x ^ y) >> bit) & 1;
    const int down = (y >> bit) & 1;
    rank = (rank << 2) | (across << 1) | down;
  }
  return rank;
}

}  // namespace mien::render
