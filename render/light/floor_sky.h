#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "render/geometry/bounding_volumes.h"
#include "render/geometry/embree_scene.h"
#include "render/scene/camera.h"
#include "render/scene/quality.h"
#include "render/scene/scene.h"

namespace mien::render {

/// Occlusion of the sky by a figure, as seen from the floor: an irradiance cache on an adaptive
/// grid. Occlusion is sampled with many rays at the corners of square cells and interpolated
/// bilinearly in between. Cells are small enough for an interpolation error of at most
/// `Quality::floor_sky_tolerance` of the sky's light. Where that would take cells smaller than
/// `Quality::floor_sky_cell`, as under the feet, the error may be larger with
/// `Quality::floor_sky_smooth`; without, the cell is not known and each pixel casts its own rays.
/// Farther than 32 m from the figure there is no occlusion.
///
/// Corners lie at the same places of the floor for every picture, and so do their rays' directions.
class FloorSky {
 public:
  /// A square of the floor.
  struct Cell {
    float x = 0.0f;
    float z = 0.0f;
    float inverse_side = 0.0f;  ///< 0: nothing is hidden
    bool known = true;
    int corners[4] = {0, 0, 0, 0};     ///< (0, 0), (1, 0), (0, 1), (1, 1)
    Color at_corner = Color::Zero();   ///< (0, 0), and how much more towards
    Color along_x = Color::Zero();     ///< (1, 0),
    Color along_z = Color::Zero();     ///< (0, 1)
    Color along_both = Color::Zero();  ///< and beyond both at (1, 1)

    bool holds(float px, float pz) const {
      const float u = (px - x) * inverse_side, v = (pz - z) * inverse_side;
      return inverse_side > 0.0f && u >= 0.0f && u < 1.0f && v >= 0.0f && v < 1.0f;
    }

    /// Hidden light (irradiance over π) at a point of the cell, if it is known.
    Color hidden(float px, float pz) const {
      const float u = (px - x) * inverse_side, v = (pz - z) * inverse_side;
      return at_corner + u * along_x + v * (along_z + u * along_both);
    }
  };

  /// Without `shapes` nothing is occluded. Outside of `view` nothing is known.
  FloorSky(const Shapes& shapes, const BoundingSphere& bounds, const Quality& quality,
           const std::array<HalfSpace, 4>& view);

  /// Number of corners to be sampled, in a fixed order.
  std::size_t corner_count() const { return corners_.size(); }

  /// Samples a corner. Different corners may be sampled at the same time.
  void sample_corner(std::size_t corner, const EmbreeScene& figure,
                     const std::vector<float>& opacities);

  /// Computes the cells; call it after all corners have been sampled.
  void finish(const Sky& sky);

  /// The cell that a point of the floor lies in.
  const Cell& cell_at(float x, float z) const;

 private:
  struct Branch {
    int children = -1;  // the first of four; −1: a leaf
    int cell = -1;
  };
  struct Corner {
    float x;
    float z;
    float even = 0.0f;    // hidden of a sky of radiance 1: irradiance over π
    float rising = 0.0f;  // and of one whose radiance is the sine of the elevation
  };
  struct Square {
    int x;  // in units
    int z;
    int side;
  };

  void divide(std::size_t branch, const Square& square);
  float interpolation_error(const Square& square) const;
  bool is_within_sphere(const Square& square) const;
  bool is_in_view(const Square& square) const;
  int corner_of(int x, int z);
  int rays_from(const Corner& corner) const;

  BoundingSphere bounds_;
  std::vector<BoundingSphere> spheres_;
  Quality quality_;
  std::array<HalfSpace, 4> view_;
  int origin_x_ = 0;  // of the root, in units
  int origin_z_ = 0;
  std::vector<Branch> branches_;
  std::vector<Cell> cells_;
  std::vector<Corner> corners_;
  std::unordered_map<std::uint64_t, int> corner_numbers_;
};

}  // namespace mien::render
