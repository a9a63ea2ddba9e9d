#pragma once

#include <cstdint>

#include "render/picture.h"
#include "render/pixel.h"
#include "render/tile.h"

namespace mien::render {

/// What a pixel gets from the set.
struct SetLight {
  Color radiance;  ///< less what the figure hides of the sky, where that is known
  bool complete;   ///< false: what the figure hides of the sky is not known, rays are to find it
};

/// Decides what of a picture need not be traced. Each thread has its own.
class PixelPlanner {
 public:
  explicit PixelPlanner(const Picture& picture)
      : picture_(picture), cell_(&picture.floor_sky.cell_at(0.0f, 0.0f)) {}

  /// Turns to a tile, which the pixels asked for from now on lie in.
  void turn_to(const Tile& tile);

  /// Whether it shows no figure and no shadow of it from a light.
  bool is_alone() const { return is_alone_; }

  /// Shows such a tile with the set behind it. False when what the figure hides of the sky is not
  /// known everywhere: then nothing there is final.
  bool show_alone(const Tile& tile, Film& film);

  SetLight set_at(int x, int y);

  /// Sets out how a pixel is to be drawn; `set` is what set_at told of it last.
  void plan(Pixel& pixel, int x, int y, const SetLight& set) const;

 private:
  void plan_floor(Pixel& pixel, const Vec3& point, bool sky_is_known) const;
  void plan_floor_sky(Pixel& pixel, const Vec3& point) const;

  const Picture& picture_;
  const FloorSky::Cell* cell_;     // of the floor, that was looked at last
  std::uint32_t tile_lights_ = 0;  // bit i: the figure may hide light i somewhere in the tile
  bool is_alone_ = false;
};

}  // namespace mien::render
