#pragma once

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

/// Draws a part of a picture, whose upper left corner is that of a tile of tile_size. A pixel
/// depends on the picture alone, not on the part it is drawn with.
///
/// The set (floor and backdrop) is known in closed form. Primary rays are traced where they may
/// meet the figure; what meets it is lit by rays to the lights and to the sky. From the floor is
/// taken away what the figure hides of the lights and of the sky, found by rays too.
void draw(const Picture& picture, const Tile& part, Exposure& exposure);

}  // namespace mien::render
