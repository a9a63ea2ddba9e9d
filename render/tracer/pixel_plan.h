#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "render/tracer/line_queries.h"
#include "render/tracer/picture.h"
#include "render/tracer/pixel.h"
#include "render/tracer/tile.h"

namespace mien::render {

/// What a pixel gets from the set.
struct SetLight {
  Color radiance;  ///< less what the figure hides of the sky, where that is known
  bool complete;   ///< false: what the figure hides of the sky is not known, rays are to find it
};

/// What a pixel may show other than the set.
struct PixelPlan {
  PixelKind kind = PixelKind::untouched;
  std::uint32_t shadow_lights = 0;  ///< bit i: the figure may hide light i from its floor
};

/// How far from a point of the floor, along its axes, metres.
struct FloorReach {
  float x;
  float z;
};

/// Decides what of a picture need not be traced. Each thread has its own.
class PixelPlanner {
 public:
  explicit PixelPlanner(const Picture& picture)
      : picture_(picture), cell_(&picture.floor_sky.cell_at(0.0f, 0.0f)) {}

  /// Turns to a tile, which the pixels that are planned from now on lie in.
  void turn_to(const Tile& tile);

  /// Whether it shows no figure and no shadow of it from a light.
  bool is_alone() const { return is_alone_; }

  /// What lines of the lights are asked for on floor in the tile.
  const TileLines& lines() const { return lines_; }

  /// Shows what each pixel gets from the set, but where what the figure hides of the sky is not
  /// known: `open` is set to 1 for tiles (from the left, tile_size pixels each) with such pixels.
  void show_set(const Tile& band, Film& film, std::vector<std::uint8_t>& open);

  SetLight set_at(int x, int y);

  PixelPlan plan(int x, int y) const;

  /// Makes a pixel ready to be drawn so; `set` is what set_at told of it last.
  void set_out(Pixel& pixel, int x, int y, const PixelPlan& plan, const SetLight& set) const;

 private:
  std::uint32_t shadow_lights(std::size_t place) const;
  void find_casters(const Tile& tile, const std::optional<FloorArea>& area);

  const Picture& picture_;
  const FloorSky::Cell* cell_;     // of the floor, that was looked at last
  std::uint32_t tile_lights_ = 0;  // bit i: the figure may hide light i somewhere in the tile
  std::optional<FloorReach> floor_reach_;  // where tile_lights_ are; none at the horizon
  bool is_alone_ = false;
  TileLines lines_;
};

}  // namespace mien::render
