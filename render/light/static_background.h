#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "render/image/framebuffer.h"
#include "render/light/unshadowed_background.h"
#include "render/scene/camera.h"
#include "render/scene/quality.h"
#include "render/scene/scene.h"

namespace mien::render {

/// The background of all pictures of one set and camera, without figures: its radiance, and the
/// properties that shadows and primary rays depend on. Rendered once.
struct StaticBackground {
  Framebuffer radiance;
  std::vector<std::uint8_t> floor;  ///< 1 where a pixel's centre shows the floor
  std::vector<std::uint8_t> solid;  ///< 1 where a static solid may show; empty: none
  CameraFrame camera;               ///< locates pixels on the floor (FloorRow)

  /// The floor's albedo, multiplied by the share that has not faded into the backdrop; black where
  /// a pixel shows no floor.
  Framebuffer albedo;

  bool shows_floor(int x, int y) const { return floor[place_of(x, y)] != 0; }
  bool may_show_solid(int x, int y) const { return !solid.empty() && solid[place_of(x, y)] != 0; }

  /// The floor's albedo at a pixel; black where the pixel does not show the floor.
  Color floor_albedo(int x, int y) const { return Eigen::Map<const Color>(albedo.at(x, y)); }

  /// Returns the index of a pixel in the lists.
  std::size_t place_of(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(radiance.width) +
           static_cast<std::size_t>(x);
  }
};

/// Returns all numbers that a static background depends on, for comparison.
std::vector<float> static_background_key(const Scene& scene, const Camera& camera,
                                         const Quality& quality);

/// Returns a name derived from such a key: its hash in 32 hexadecimal digits (128 bits).
std::string static_background_name(const std::vector<float>& key);

/// Renders the floor and backdrop of a row at the centres of the pixels (UnshadowedRow). If there
/// are no static solids, this is the whole background of the row.
void render_unshadowed_row(const UnshadowedBackground& open, int y, StaticBackground& background);

/// Returns a background of this size without solids, whose rows are still to be rendered; it reuses
/// the memory of `used`.
StaticBackground blank_background(int width, int height, const CameraFrame& camera,
                                  StaticBackground used = {});

}  // namespace mien::render
