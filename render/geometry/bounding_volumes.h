#pragma once

#include <cstdint>
#include <vector>

#include "render/geometry/shapes.h"
#include "render/scene/camera.h"
#include "render/scene/scene.h"

namespace mien::render {

// Conservative bounds of a figure, by which rays are culled: they may report an intersection where
// there is none, never the reverse.

/// A sphere that contains all shapes; radius −1 if there are none.
struct BoundingSphere {
  Vec3 centre = Vec3::Zero();
  float radius = -1.0f;
};
BoundingSphere bounding_sphere(const Shapes& shapes);

/// Whether a ray of unit direction may meet what is in the sphere.
bool may_intersect(const BoundingSphere& sphere, const Vec3& origin, const Vec3& direction);

/// Spheres that together contain all shapes, few but tight.
std::vector<BoundingSphere> bounding_spheres(const Shapes& shapes);

/// The pixels whose primary rays, anywhere under a filter of that half width, may meet a
/// shape.
class PixelMask {
 public:
  PixelMask(const Camera& camera, const Shapes& shapes, float filter_half_width);

  bool may_intersect(int x, int y) const { return ((word(x / bits, y) >> (x % bits)) & 1u) != 0; }

  /// Whether any of the pixels [x_begin, x_end) of a row may.
  bool may_intersect_row(int x_begin, int x_end, int y) const;

 private:
  static constexpr int bits = 64;  // of a word

  std::uint64_t word(int column, int y) const {
    return words_[static_cast<std::size_t>(y) * static_cast<std::size_t>(words_across_) +
                  static_cast<std::size_t>(column)];
  }
  void touch(int x_begin, int x_end, int y);

  int words_across_;
  std::vector<std::uint64_t> words_;  // bit i of word k of a row: pixel 64 k + i
};

}  // namespace mien::render
