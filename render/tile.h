#pragma once

#include "render/film.h"
#include "render/picture.h"

namespace mien::render {

/// Pixels [x_begin, x_end) × [y_begin, y_end).
struct Tile {
  int x_begin;
  int x_end;
  int y_begin;
  int y_end;
};

inline constexpr int tile_size = 16;

/// The tile in that column and row of tiles, cut off at the film's edge.
Tile tile_at(const Film& film, int column, int row);

/// Draws the pixels of a tile, at most tile_size on a side. A pixel depends on the picture alone,
/// not on its tile.
///
/// The set (floor and backdrop) is known in closed form. Primary rays are traced where they may
/// meet the figure; what meets it is lit by rays to the lights and to the sky. From the floor is
/// taken away what the figure hides of the lights and of the sky, found by rays too.
void draw(const Picture& picture, const Tile& tile, Exposure& exposure);

}  // namespace mien::render
