#pragma once

#include <cstdint>
#include <vector>

#include "render/geometry/round_cone.h"
#include "render/geometry/triangle.h"
#include "render/scene/scene.h"

namespace mien::render {

/// Which triangle of which mesh.
struct TriangleSource {
  int mesh;
  int triangle;
};

/// Solids made ready for tracing. Shapes are numbered: first the round cones, then the triangles of
/// all meshes.
///
/// Where a shutter is open for a while, every shape has a second place, at its end, and goes
/// straight from the first to the second; otherwise the closing lists are empty.
struct Shapes {
  std::vector<RoundCone> cones;
  std::vector<RoundCone> closing_cones;
  std::vector<Triangle> triangles;
  std::vector<Triangle> closing_triangles;
  std::vector<TriangleSource> sources;  ///< of the triangles
  std::vector<std::uint8_t> figures;    ///< one a shape: index into Scene::figures
  bool all_present = true;              ///< no figure's opacity is below 1

  bool empty() const { return cones.empty() && triangles.empty(); }
  bool move() const { return !closing_cones.empty() || !closing_triangles.empty(); }

  RoundCone cone_at(std::size_t index, float time) const;
  Triangle triangle_at(std::size_t index, float time) const;
};

/// The figures of a valid scene, where they stand.
Shapes figure_shapes(const Scene& scene);

/// What stands in its set, which is always there as a whole.
Shapes standing_shapes(const Scene& scene);

/// The solids of two scenes, when the shutter opens and when it closes. Throws
/// std::invalid_argument unless both hold the same shapes in the same order.
Shapes shapes_between(const Scene& opening, const Scene& closing);

}  // namespace mien::render
