#pragma once

#include <cstdint>
#include <vector>

#include "render/geometry/shapes.h"
#include "render/scene/camera.h"
#include "render/scene/scene.h"

namespace mien::render {

// Conservative bounds of a figure for culling rays: they may report an intersection where there is
// none, but never miss one.

/// A sphere that contains all shapes; radius −1 if there are none.
struct BoundingSphere {
  Vec3 centre = Vec3::Zero();
  float radius = -1.0f;
};
BoundingSphere bounding_sphere(const Shapes& shapes);

/// Returns whether a ray with unit direction may hit the contents of the sphere.
bool may_intersect(const BoundingSphere& sphere, const Vec3& origin, const Vec3& direction);

/// A piece of a figure: a sphere around it, and how much of a view it covers.
struct FigurePiece {
  BoundingSphere sphere;
  float silhouette = 0.0f;  ///< area, mean over all directions, m²
};

/// Pieces that together contain all shapes: few, but with tight spheres. The silhouettes of meshes
/// are those of closed surfaces.
std::vector<FigurePiece> pieces_of(const Shapes& shapes);

/// The pixels whose primary rays may hit a shape, at any offset within the reconstruction filter.
/// The filter's half width is in pixels.
class PixelMask {
 public:
  PixelMask(const Camera& camera, const Shapes& shapes, float filter_half_width);

  bool may_intersect(int x, int y) const { return ((word(x / bits, y) >> (x % bits)) & 1u) != 0; }

  /// Returns whether the primary rays of any of the pixels [x_begin, x_end) of a row may hit a
  /// shape.
  bool may_intersect_row(int x_begin, int x_end, int y) const;

 private:
  static constexpr int bits = 64;  // bits per word

  std::uint64_t word(int column, int y) const {
    return words_[static_cast<std::size_t>(y) * static_cast<std::size_t>(words_across_) +
                  static_cast<std::size_t>(column)];
  }
  void touch(int x_begin, int x_end, int y);

  int words_across_;
  std::vector<std::uint64_t> words_;  // bit i of word k of a row: pixel 64 k + i
};

}  // namespace mien::render
