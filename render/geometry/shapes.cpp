#include "render/geometry/shapes.h"

#include <stdexcept>

namespace mien::render {
namespace {

Vec3 between(const Vec3& from, const Vec3& to, float time) { return from + time * (to - from); }

void add_triangles(const Mesh& mesh, std::vector<Triangle>& triangles) {
  const auto corner = [&](int index) { return mesh.positions[static_cast<std::size_t>(index)]; };
  for (const auto& [a, b, c] : mesh.triangles)
    triangles.push_back({corner(a), corner(b), corner(c)});
}

std::uint8_t figure_of(int part, const Scene& scene) {
  return static_cast<std::uint8_t>(scene.parts[static_cast<std::size_t>(part)].figure);
}

int part_of(const Mesh& mesh, int triangle) {
  return mesh.triangle_parts.empty() ? mesh.part
                                     : mesh.triangle_parts[static_cast<std::size_t>(triangle)];
}

/// Without their figures.
Shapes bare_shapes(const Solids& solids) {
  Shapes shapes;
  shapes.cones = prepared_cones(solids);
  for (std::size_t m = 0; m < solids.meshes.size(); ++m) {
    add_triangles(solids.meshes[m], shapes.triangles);
    for (std::size_t t = 0; t < solids.meshes[m].triangles.size(); ++t)
      shapes.sources.push_back({static_cast<int>(m), static_cast<int>(t)});
  }
  return shapes;
}

bool alike(const Solids& a, const Solids& b) {
  if (a.spheres.size() != b.spheres.size() || a.round_cones.size() != b.round_cones.size() ||
      a.meshes.size() != b.meshes.size())
    return false;
  for (std::size_t i = 0; i < a.meshes.size(); ++i) {
    if (a.meshes[i].triangles != b.meshes[i].triangles ||
        a.meshes[i].positions.size() != b.meshes[i].positions.size())
      return false;
  }
  return true;
}

}  // namespace

PreparedCone Shapes::cone_at(std::size_t index, float time) const {
  const PreparedCone& from = cones[index];
  if (closing_cones.empty()) return from;
  const PreparedCone& to = closing_cones[index];
  RoundCone moved;
  moved.start = between(from.a, to.a, time);
  moved.end = between(from.b(), to.b(), time);
  moved.start_radius = from.radius_a + time * (to.radius_a - from.radius_a);
  moved.end_radius = from.radius_b + time * (to.radius_b - from.radius_b);
  moved.material = from.material;
  moved.part = from.part;
  return prepared_cone(moved);
}

Triangle Shapes::triangle_at(std::size_t index, float time) const {
  const Triangle& from = triangles[index];
  if (closing_triangles.empty()) return from;
  const Triangle& to = closing_triangles[index];
  return {between(from.a, to.a, time), between(from.b, to.b, time), between(from.c, to.c, time)};
}

Shapes figure_shapes(const Scene& scene) {
  Shapes shapes = bare_shapes(scene.solids);
  for (const PreparedCone& cone : shapes.cones)
    shapes.figures.push_back(figure_of(cone.part, scene));
  for (const TriangleSource& source : shapes.sources) {
    const Mesh& mesh = scene.solids.meshes[static_cast<std::size_t>(source.mesh)];
    shapes.figures.push_back(figure_of(part_of(mesh, source.triangle), scene));
  }
  for (const std::uint8_t figure : shapes.figures)
    if (scene.figures[figure].opacity < 1.0f) shapes.all_present = false;
  return shapes;
}

Shapes static_shapes(const Scene& scene) {
  Shapes shapes = bare_shapes(scene.static_solids);
  shapes.figures.assign(shapes.cones.size() + shapes.triangles.size(), 0);
  return shapes;
}

Shapes shapes_between(const Scene& opening, const Scene& closing) {
  if (!alike(opening.solids, closing.solids))
    throw std::invalid_argument("closing: holds other solids than the opening scene");
  Shapes shapes = figure_shapes(opening);
  shapes.closing_cones = prepared_cones(closing.solids);
  for (const Mesh& mesh : closing.solids.meshes) add_triangles(mesh, shapes.closing_triangles);
  return shapes;
}

}  // namespace mien::render
