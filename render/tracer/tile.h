#pragma once

#include <cstddef>
#include <functional>

#include "render/image/framebuffer.h"
#include "render/image/window.h"
#include "render/tracer/prepared_scene.h"

namespace mien::render {

/// Width and height of a tile, pixels.
inline constexpr int tile_size = 16;

/// The target of a part of a picture: pixel (x, y) of the picture is pixel (x − left, y − top) of
/// the target.
struct Canvas {
  RenderTarget& target;
  int left = 0;
  int top = 0;

  float* color(int x, int y) const { return target.color.at(x - left, y - top); }
  float& alpha(int x, int y) const {
    return target
        .alpha[static_cast<std::size_t>(y - top) * static_cast<std::size_t>(target.color.width) +
               static_cast<std::size_t>(x - left)];
  }
};

/// Alpha of a shadow: the share of the luminance of the whole background that is missing.
float shadow_alpha(const Color& left, const Color& whole);

/// Renders the pixels of `part`, of one tile or several adjacent ones. A pixel depends
/// on the prepared scene alone, not on the part that it is rendered with.
///
/// The background (floor, backdrop and static solids) is known beforehand, except for pixels of
/// PixelKind::per_sample. Primary rays are traced where they may hit the figure or static solids.
/// Surfaces of the figure are lit by rays to the lights and to the sky. Light that the figure keeps
/// from reaching static solids and the floor is subtracted; shadow rays find it, for the sky on the
/// floor at points of a grid (floor_sky.h) or, where that is too coarse, for each pixel. Pixels may
/// share what such rays find (shared_occlusion.h).
void draw(const PreparedScene& prepared, const Window& part, const Canvas& canvas);

/// As `draw`, but in small pieces, and only for pictures without alpha (Background::shown): `drawn`
/// is called with each piece as soon as it is rendered, while its framebuffer is still in the
/// processor's caches.
void draw_pieces(
    const PreparedScene& prepared, const Window& part,
    const std::function<void(const Window& piece, const Framebuffer& framebuffer)>& drawn);

}  // namespace mien::render
