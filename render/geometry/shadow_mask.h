#pragma once

#include <cstdint>
#include <vector>

#include "render/geometry/shapes.h"
#include "render/scene/scene.h"

namespace mien::render {

/// A rectangle of the floor, metres.
struct FloorArea {
  float x_min;
  float x_max;
  float z_min;
  float z_max;
};

/// Whether all of a solid lies on the side of the light's plane that it does not shine to, where it
/// hides nothing.
bool is_behind(const AreaLight& light, const PreparedCone& solid);

/// The part of the floor on which a shape may hide a part of a light: a grid of cells.
class ShadowMask {
 public:
  ShadowMask(const AreaLight& light, const Shapes& shapes);

  /// Whether any point of the area may lie in umbra or penumbra.
  bool may_shade(const FloorArea& area) const;

  /// Whether every point of the area may, by the resolution of the grid.
  bool may_shade_all(const FloorArea& area) const;

  /// Adds the indices of the round cones that may hide a part of the light somewhere in the area,
  /// in rising order. Returns the least height above the floor, metres, of the pieces that do;
  /// infinity if there are none.
  float add_casters(const FloorArea& area, std::vector<int>& cones) const;

 private:
  static constexpr int cells = 128;  // a side

  /// The area of the floor on which a piece of a round cone may hide the light.
  struct Caster {
    FloorArea area;
    int cone;
    float height;  // of its lowest point
  };

  int column(float x) const;
  int row(float z) const;

  bool everywhere_ = false;
  FloorArea area_{0.0f, -1.0f, 0.0f, -1.0f};
  float columns_per_metre_ = 0.0f;
  float rows_per_metre_ = 0.0f;
  std::vector<std::uint8_t> touched_;
  std::vector<Caster> casters_;
};

}  // namespace mien::render
