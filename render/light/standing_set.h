#pragma once

#include <cstdint>
#include <optional>
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
  std::vector<std::uint8_t> floor;  ///< 1 where a pixel's centre shows the floor
  std::vector<std::uint8_t> solid;  ///< 1 where a pixel may show a standing solid; empty without
  CameraFrame camera;               ///< tells where the floor is seen (FloorRow)

  /// The floor's albedo, times how little of it has faded. Of a row whose floor is of one colour
  /// that alone is known, which is sooner read.
  std::vector<std::optional<Color>> even_albedo;  ///< one a row
  Film albedo;                                    ///< of the other rows

  bool shows_floor(int x, int y) const { return floor[place_of(x, y)] != 0; }
  bool may_show_solid(int x, int y) const { return !solid.empty() && solid[place_of(x, y)] != 0; }

  /// Black where a pixel does not show the floor.
  Color floor_albedo(int x, int y) const {
    if (!shows_floor(x, y)) return Color::Zero();
    const std::optional<Color>& even = even_albedo[static_cast<std::size_t>(y)];
    return even ? *even : Color(Eigen::Map<const Color>(albedo.at(x, y)));
  }

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

/// The floor and backdrop of a row at the centres of the pixels (OpenRow): all of a set without
/// solids.
void expose_open_row(const OpenSet& open, int y, StandingSet& set);

/// Room for the set of a picture of that size, none of it solid: that of another, or new. Before
/// all rows are exposed of no meaning.
StandingSet room_for(int width, int height, const CameraFrame& camera, StandingSet used = {});

}  // namespace mien::render
