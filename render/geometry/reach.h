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

  bool may_meet(int x, int y) const { return ((word(x / bits, y) >> (x % bits)) & 1u) != 0; }

  /// Any of the pixels [x_begin, x_end) of a row.
  bool may_meet_row(int x_begin, int x_end, int y) const;

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
