#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "render/geometry/shadow_mask.h"
#include "render/light/floor.h"
#include "render/tracer/prepared_scene.h"
#include "render/tracer/samples.h"
#include "render/tracer/tile.h"

namespace mien::render {

/// What a pixel needs.
struct PixelPlan {
  PixelKind kind = PixelKind::background;
  std::uint32_t shadow_lights = 0;  ///< bit i: the figure may occlude light i from its floor

  bool shows_background_only() const { return kind == PixelKind::background && shadow_lights == 0; }
};

/// Decides what needs to be traced for each pixel. Each thread has its own.
class PixelPlanner {
 public:
  explicit PixelPlanner(const PreparedScene& prepared)
      : prepared_(prepared),
        per_sample_(prepared.is_per_sample()),
        asks_all_lights_(prepared.quality.exhaustive && prepared.quality.floor_sharing_pixels == 0),
        cell_(&prepared.floor_sky.cell_at(0.0f, 0.0f)) {}

  void begin_tile(const Window& tile);

  /// Whether the figure may occlude a light from some of the tile's floor.
  bool may_show_shadow() const { return tile_lights_ != 0; }

  /// Whether the tile shows neither the figure nor its shadow from a light; always false if the set
  /// has static solids or samples render their own background.
  bool shows_background_only() const { return shows_background_only_; }

  /// Plans a row of the tile, from its first column on.
  const std::array<PixelPlan, tile_size>& plan_row(int y);

  /// Writes the background of each pixel of a row of tiles, except where the occlusion of the sky
  /// is not known: `is_known` of tiles with such pixels, counted from the left, becomes 0.
  void write_background(const Window& band, const Canvas& canvas,
                        std::vector<std::uint8_t>& is_known);

  /// Returns the radiance of a pixel's background less the figure's occlusion of the sky; nothing
  /// if that is not known and needs rays.
  std::optional<Color> background_at(int x, int y);

  /// The sky rays of a pixel whose occlusion of the sky is not known.
  SkyRays floor_sky_rays(int x, int y);

 private:
  PixelPlan plan(int x, int y, std::uint32_t lights) const;
  std::uint32_t shadow_lights(int first, int last, int y);
  const FloorRow& floor_row(int y);

  const PreparedScene& prepared_;
  const bool per_sample_;
  const bool asks_all_lights_;  // also where the figure occludes none
  const FloorSky::Cell* cell_;  // last cell of the floor that was used
  Window tile_{};
  std::uint32_t tile_lights_ = 0;  // bit i: the figure may occlude light i somewhere in the tile
  // How far the floor that a pixel's samples show extends from that at its centre, along x and z,
  // metres; none at the horizon. Only if the tile has tile_lights_.
  std::optional<FloorPlace> floor_reach_;
  std::uint32_t figure_rows_ = 0;  // bit i: row i of the tile may show the figure
  bool shows_background_only_ = false;
  std::array<PixelPlan, tile_size> plans_;
  FloorRow row_;  // last row used
  int row_number_ = -1;
};

}  // namespace mien::render
