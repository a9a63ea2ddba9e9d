#pragma once

#include <cstdint>
#include <vector>

#include "render/geometry/shapes.h"
#include "render/scene/camera.h"
#include "render/scene/scene.h"

namespace mien::render {

// What a figure can touch, so that rays that cannot meet it need not be traced. All of these err on
// the side of touching.

/// A sphere around all shapes; radius −1 around none.
struct BoundingSphere {
  Vec3 centre = Vec3::Zero();
  float radius = -1.0f;
};
BoundingSphere bounding_sphere(const Shapes& shapes);

/// Whether a ray of unit direction may meet what is in the sphere.
bool may_meet(const BoundingSphere& sphere, const Vec3& origin, const Vec3& direction);

/// Spheres that together hold all shapes, about as many as tell where they are.
std::vector<BoundingSphere> bounding_spheres(const Shapes& shapes);

/// The pixels whose primary rays, anywhere under a filter of that half width, may meet a
/// shape.
class FilmMask {
 public:
  FilmMask(const Camera& camera, const Shapes& shapes, float filter_half_width);

  bool may_meet(int x, int y) const {
    return touched_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                    static_cast<std::size_t>(x)] != 0;
  }

  /// Any of the pixels [x_begin, x_end) of a row.
  bool may_meet_row(int x_begin, int x_end, int y) const;

 private:
  int width_;
  std::vector<std::uint8_t> touched_;
};

/// A rectangle of the floor, metres.
struct FloorArea {
  float x_min;
  float x_max;
  float z_min;
  float z_max;
};

/// The part of the floor on which a shape may hide a part of a light: a grid of cells.
class ShadowMask {
 public:
  ShadowMask(const AreaLight& light, const Shapes& shapes);

  /// Whether any point of the area may lie in shadow or half shadow.
  bool may_shade(const FloorArea& area) const;

 private:
  static constexpr int cells = 128;  // a side

  int column(float x) const;
  int row(float z) const;

  bool everywhere_ = false;
  FloorArea area_{0.0f, -1.0f, 0.0f, -1.0f};
  float columns_per_metre_ = 0.0f;
  float rows_per_metre_ = 0.0f;
  std::vector<std::uint8_t> touched_;
};

}  // namespace mien::render
