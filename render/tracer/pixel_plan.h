#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "render/light/floor_row.h"
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
      : picture_(picture),
        piecemeal_(picture.piecemeal()),
        cell_(&picture.floor_sky.cell_at(0.0f, 0.0f)) {}

  /// Turns to a tile, which the pixels that are planned from now on lie in.
  void turn_to(const Tile& tile);

  /// Whether it shows no figure and no shadow of it from a light.
  bool is_alone() const { return is_alone_; }

  /// What lines of the lights are asked for on floor in the tile.
  const TileLines& lines() const { return lines_; }

  /// Shows what each pixel gets from the set, but where what the figure hides of the sky is not
  /// known: `open` is set to 1 for tiles (from the left, tile_size pixels each) with such pixels.
  void show_set(const Tile& band, const Canvas& canvas, std::vector<std::uint8_t>& open);

  SetLight set_at(int x, int y);

  /// Makes a pixel ready that shows floor, of which only what lines find is not known.
  void set_out(FloorPixel& pixel, int x, int y, const PixelPlan& plan, const Color& radiance) const;

  PixelPlan plan(int x, int y);

  /// Pixels of the tile's row y, from x on, of which is soon told that they show no figure, and
  /// which lights they may lack; none where nothing is.
  struct Alike {
    int end;
    std::uint32_t lights;  ///< that some may lack; 0, or all of them show the floor
  };
  std::optional<Alike> alike_from(int x, int y);

  /// Makes a pixel ready to be drawn so; `set` is what set_at told of it last.
  void set_out(Pixel& pixel, int x, int y, const PixelPlan& plan, const SetLight& set);

 private:
  /// Pixels of a row, and what they may lack.
  struct Stretch {
    int row = -1;
    int first = 0;
    int last = -1;
    std::uint32_t lights = 0;
  };

  std::uint32_t shadow_lights(int x, int y);
  std::uint32_t lights_hidden_in(const Stretch& stretch);
  const FloorRow& floor_row(int y);
  void find_casters(const Tile& tile, const std::optional<FloorArea>& area);

  const Picture& picture_;
  const bool piecemeal_;
  const FloorSky::Cell* cell_;      // of the floor, that was looked at last
  std::uint32_t tile_lights_ = 0;   // bit i: the figure may hide light i somewhere in the tile
  bool shaded_everywhere_ = false;  // by all of tile_lights_, as far as is known
  int end_ = 0;                     // of the tile's columns
  std::optional<FloorReach> floor_reach_;  // where tile_lights_ are; none at the horizon
  std::uint32_t figure_rows_ = 0;          // bit i: row i of the tile may show the figure
  int first_row_ = 0;                      // of the tile
  bool is_alone_ = false;

  Stretch stretch_;  // that was looked at last, in the tile
  FloorRow row_;     // likewise
  int row_number_ = -1;
  TileLines lines_;
};

}  // namespace mien::render
