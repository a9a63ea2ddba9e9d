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
/// bilinearly in between. Cells are small enough for an estimated interpolation error of at most
/// `Quality::floor_sky_tolerance` of the sky's light; the estimate takes the figure's pieces for
/// closed solids seen from any side (FigurePiece). Where that would require cells smaller than
/// `Quality::floor_sky_cell`, such as under the feet, the error may be larger with
/// `Quality::floor_sky_smooth`; without it the cell is unknown and each pixel casts its own rays.
/// Cells that lie within the sphere around a piece are not divided, but unknown, too.
/// Occlusion is neglected outside a square of 128 m, which extends at least 32 m from the figure's
/// centre on each side.
///
/// Corners have the same positions on the floor and use the same random numbers in every picture.
class FloorSky {
 public:
  /// A square of the floor.
  struct Cell {
    float x = 0.0f;
    float z = 0.0f;
    float inverse_side = 0.0f;  ///< 1/metres; 0: nothing is occluded
    bool known = true;
    int corners[4] = {0, 0, 0, 0};     ///< indices, at (0, 0), (1, 0), (0, 1), (1, 1)
    Color at_corner = Color::Zero();   ///< occluded light at (0, 0)
    Color along_x = Color::Zero();     ///< its increase towards (1, 0)
    Color along_z = Color::Zero();     ///< its increase towards (0, 1)
    Color along_both = Color::Zero();  ///< the bilinear term

    bool holds(float px, float pz) const {
      const float u = (px - x) * inverse_side, v = (pz - z) * inverse_side;
      return inverse_side > 0.0f && u >= 0.0f && u < 1.0f && v >= 0.0f && v < 1.0f;
    }

    /// Returns the occluded light (irradiance divided by π) at a point of a known cell.
    Color hidden(float px, float pz) const {
      const float u = (px - x) * inverse_side, v = (pz - z) * inverse_side;
      return at_corner + u * along_x + v * (along_z + u * along_both);
    }
  };

  /// If `shapes` is empty, nothing is occluded. Cells outside `view` are unknown.
  FloorSky(const Shapes& shapes, const BoundingSphere& bounds, const Quality& quality,
           const std::array<HalfSpace, 4>& view);

  /// Number of corners to be sampled, in a fixed order.
  std::size_t corner_count() const { return corners_.size(); }

  /// Samples a corner. Different corners may be sampled at the same time.
  void sample_corner(std::size_t corner, const EmbreeScene& figure,
                     const std::vector<float>& opacities);

  /// Computes the cells; call it after all corners have been sampled.
  void finish(const Sky& sky);

  /// Returns the cell that contains a point of the floor.
  const Cell& cell_at(float x, float z) const;

 private:
  struct Corner {
    float x;
    float z;
    float even = 0.0f;    // occluded irradiance, divided by π, of a sky of radiance 1
    float rising = 0.0f;  // the same for a sky whose radiance is the sine of the elevation
  };
  struct Square {
    int x;  // in units of 1/64 m
    int z;
    int side;
  };

  void divide(std::size_t branch, const Square& square);
  void end_with(std::size_t branch, const Cell& cell);
  float interpolation_error(const Square& square) const;
  bool is_within_sphere(const Square& square) const;
  bool is_in_view(const Square& square) const;
  int corner_of(int x, int z);
  int rays_from(const Corner& corner) const;

  BoundingSphere bounds_;
  std::vector<FigurePiece> pieces_;
  Quality quality_;
  std::array<HalfSpace, 4> view_;
  int origin_x_ = 0;  // of the root, in units of 1/64 m
  int origin_z_ = 0;
  // Of squares, the root first: the number of the first of its four quarters; of those that are not
  // divided, the complement of their cell's number, which is negative.
  std::vector<int> branches_;
  std::vector<Cell> cells_;
  std::vector<Corner> corners_;
  std::unordered_map<std::uint64_t, int> corner_numbers_;
};

}  // namespace mien::render
