#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "render/light/floor_row.h"
#include "render/tracer/line_shadow_queue.h"
#include "render/tracer/pixel.h"
#include "render/tracer/prepared_scene.h"
#include "render/tracer/tile.h"

namespace mien::render {

/// The background of a pixel.
struct BackgroundLight {
  Color radiance;  ///< minus the figure's occlusion of the sky, if that is known
  bool complete;   ///< false: the occlusion of the sky is not known and needs rays
};

/// What a pixel may show besides the background.
struct PixelPlan {
  PixelKind kind = PixelKind::background;
  std::uint32_t shadow_lights = 0;  ///< bit i: the figure may occlude light i from its floor
};

/// A distance on the floor, along each axis, metres.
struct FloorReach {
  float x;
  float z;
};

/// Decides what needs to be traced for each pixel. Each thread has its own.
class PixelPlanner {
 public:
  explicit PixelPlanner(const PreparedScene& prepared)
      : prepared_(prepared),
        per_sample_(prepared.is_per_sample()),
        cell_(&prepared.floor_sky.cell_at(0.0f, 0.0f)) {}

  /// Begins a tile: the pixels planned from now on lie in it.
  void begin_tile(const Tile& tile);

  /// Whether the tile shows neither the figure nor its shadow from a light; always false if the set
  /// has static solids or samples render their own background.
  bool shows_background_only() const { return shows_background_only_; }

  /// Line shadows on the floor of the tile.
  const TileLineShadows& lines() const { return lines_; }

  /// Writes the background of each pixel, except where the occlusion of the sky is not known:
  /// `open` is set to 1 for tiles (from the left, tile_size pixels each) with such pixels.
  void write_background(const Tile& band, const Canvas& canvas, std::vector<std::uint8_t>& open);

  BackgroundLight background_at(int x, int y);

  /// Initialises a pixel that shows floor and needs line shadows only.
  void init(FloorPixel& pixel, int x, int y, const PixelPlan& plan, const Color& radiance) const;

  PixelPlan plan(int x, int y);

  /// A run of pixels in a row that show no figure and can only be shadowed from the given lights.
  /// There is none if the pixel at (x, y) must be planned by itself.
  struct UniformRun {
    int end;
    std::uint32_t lights;  ///< lights that may be occluded; if not 0, the whole run shows the floor
  };
  std::optional<UniformRun> uniform_run_from(int x, int y);

  /// Initialises a pixel; `background` is the result of background_at for it.
  void init(Pixel& pixel, int x, int y, const PixelPlan& plan, const BackgroundLight& background);

 private:
  /// A span of a row, and the lights that may be occluded from it.
  struct PixelSpan {
    int row = -1;
    int first = 0;
    int last = -1;
    std::uint32_t lights = 0;
  };

  std::uint32_t shadow_lights(int x, int y);
  std::uint32_t lights_hidden_in(const PixelSpan& stretch);
  const FloorRow& floor_row(int y);
  void find_casters(const Tile& tile, const std::optional<FloorArea>& area);

  const PreparedScene& prepared_;
  const bool per_sample_;
  const FloorSky::Cell* cell_;      // last cell of the floor that was used
  std::uint32_t tile_lights_ = 0;   // bit i: the figure may occlude light i somewhere in the tile
  bool shaded_everywhere_ = false;  // every pixel may be shadowed from all of tile_lights_
  int end_ = 0;                     // end of the tile's columns
  // Of the tile if it has tile_lights_; none at the horizon.
  std::optional<FloorReach> floor_reach_;
  std::uint32_t figure_rows_ = 0;  // bit i: row i of the tile may show the figure
  int first_row_ = 0;              // first row of the tile
  bool shows_background_only_ = false;

  PixelSpan span_;  // last span used in the tile
  FloorRow row_;    // last row used
  int row_number_ = -1;
  TileLineShadows lines_;
};

}  // namespace mien::render
