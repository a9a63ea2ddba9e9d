#pragma once

#include <cstdint>
#include <vector>

#include "render/geometry/prepared_cone.h"
#include "render/geometry/triangle.h"
#include "render/scene/scene.h"

namespace mien::render {

/// The mesh, and the triangle within it, that a traced triangle comes from (indices).
struct TriangleSource {
  int mesh;
  int triangle;
};

/// Solids prepared for tracing. Shapes are numbered: first the round cones, then the triangles of
/// all meshes.
///
/// With motion blur every shape has a second position, at shutter close, and moves to it in a
/// straight line; otherwise the closing lists are empty.
struct Shapes {
  std::vector<PreparedCone> cones;
  std::vector<PreparedCone> closing_cones;
  std::vector<Triangle> triangles;
  std::vector<Triangle> closing_triangles;
  std::vector<TriangleSource> sources;  ///< source of each triangle
  std::vector<std::uint8_t> figures;    ///< per shape: index into Scene::figures
  bool all_present = true;              ///< whether no figure has an opacity below 1

  bool empty() const { return cones.empty() && triangles.empty(); }
  bool move() const { return !closing_cones.empty() || !closing_triangles.empty(); }

  PreparedCone cone_at(std::size_t index, float time) const;
  Triangle triangle_at(std::size_t index, float time) const;
};

/// The shapes of the figures of a valid scene.
Shapes figure_shapes(const Scene& scene);

/// The shapes of the static solids of a scene, which are always fully opaque.
Shapes static_shapes(const Scene& scene);

/// The shapes of the figures as they move from `opening`, the scene at shutter open, to `closing`,
/// the scene at shutter close. Both must hold the same shapes in the same order; throws
/// std::invalid_argument if their numbers or the meshes' triangles differ.
Shapes shapes_between(const Scene& opening, const Scene& closing);

}  // namespace mien::render
