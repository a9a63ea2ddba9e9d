#pragma once

#include <cstddef>
#include <functional>

#include "render/image/film.h"
#include "render/tracer/picture.h"

namespace mien::render {

/// Pixels [x_begin, x_end) × [y_begin, y_end): of a tile, or of several.
struct Tile {
  int x_begin;
  int x_end;
  int y_begin;
  int y_end;
};

inline constexpr int tile_size = 16;

/// What a part of a picture is drawn on: pixel (x, y) of the picture is pixel (x − left, y − top)
/// of the exposure.
struct Canvas {
  Exposure& exposure;
  int left = 0;
  int top = 0;

  float* film(int x, int y) const { return exposure.film.at(x - left, y - top); }
  float& alpha(int x, int y) const {
    return exposure
        .alpha[static_cast<std::size_t>(y - top) * static_cast<std::size_t>(exposure.film.width) +
               static_cast<std::size_t>(x - left)];
  }
};

/// Draws a part of a picture, whose upper left corner is that of a tile of tile_size. A pixel
/// depends on the picture alone, not on the part it is drawn with.
///
/// The set (floor and backdrop) is known in closed form. Primary rays are traced where they may
/// meet the figure; what meets it is lit by rays to the lights and to the sky. From the floor is
/// taken away what the figure hides of the lights and of the sky, found by rays too.
void draw(const Picture& picture, const Tile& part, const Canvas& canvas);

/// Likewise of a picture whose background is shown, piece by piece, each on a film of its own that
/// stays in the processor's caches: `drawn` is told of each at once.
void draw_pieces(const Picture& picture, const Tile& part,
                 const std::function<void(const Tile& piece, const Film& film)>& drawn);

}  // namespace mien::render
