#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "render/image/film.h"
#include "render/light/open_set.h"
#include "render/scene/camera.h"
#include "render/scene/quality.h"
#include "render/scene/scene.h"

namespace mien::render {

/// The set with nobody in it, through one camera: what it looks like, and what else a picture needs
/// to know of it. It is worked out once and serves all pictures of that set and camera.
struct StandingSet {
  Film radiance;
  Film floor_albedo;                ///< of the floor, times how little of it has faded
  std::vector<std::uint8_t> floor;  ///< 1 where a pixel's centre shows the floor
  std::vector<float> floor_x;       ///< where on the floor, metres
  std::vector<float> floor_z;
  std::vector<std::uint8_t> solid;  ///< 1 where a pixel may show a standing solid

  /// Where a pixel is in the lists.
  std::size_t place_of(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(radiance.width) +
           static_cast<std::size_t>(x);
  }
};

/// All numbers that a standing set depends on, for comparison.
std::vector<float> standing_key(const Scene& scene, const Camera& camera, const Quality& quality);

/// A name for a set with that key, 32 hexadecimal digits: two sets have the same by a chance of
/// 2⁻¹²⁸.
std::string standing_name(const std::vector<float>& key);

/// The floor and backdrop of a row, in closed form at the centres of the pixels: all of a set
/// without solids.
void expose_open_row(const OpenSet& open, int y, StandingSet& set);

/// Room for the set of a picture of that size, none of it solid: that of another, or new.
StandingSet room_for(int width, int height, StandingSet used = {});

}  // namespace mien::render
