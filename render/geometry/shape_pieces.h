#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "render/geometry/box.h"
#include "render/geometry/shapes.h"

namespace mien::render {

/// One of the balls whose convex hull bounds a piece of a shape.
struct Ball {
  Vec3 centre;
  float radius;
};

/// Calls `visit` with each piece of a shape, as balls whose convex hull bounds the piece. A round
/// cone becomes a chain of pieces about as long as they are thick, whose boxes are tighter than one
/// box around the whole. A moving shape is bounded by the hull of its two positions.
template <class Visit>
void visit_pieces(const PreparedCone& cone, const PreparedCone* closing, Visit visit) {
  const float thickness = 2.0f * std::max(std::max(cone.radius_a, cone.radius_b), 1e-3f);
  const int pieces = std::clamp(static_cast<int>(std::ceil(cone.axis.norm() / thickness)), 1, 16);
  const auto ball = [&](const PreparedCone& of, int i) {
    const float t = static_cast<float>(i) / static_cast<float>(pieces);
    return Ball{of.a + t * of.axis, of.radius_a + t * (of.radius_b - of.radius_a)};
  };
  for (int i = 0; i < pieces; ++i) {
    if (closing == nullptr) {
      visit(std::array{ball(cone, i), ball(cone, i + 1)});
    } else {
      // At times between its two positions, the moving cone may have become a sphere of the largest
      // radius, anywhere on its axis.
      std::array balls{ball(cone, i), ball(cone, i + 1), ball(*closing, i), ball(*closing, i + 1)};
      const float radius =
          std::max({cone.radius_a, cone.radius_b, closing->radius_a, closing->radius_b});
      for (Ball& each : balls) each.radius = radius;
      visit(balls);
    }
  }
}

template <class Visit>
void visit_pieces(const Triangle& triangle, const Triangle* closing, Visit visit) {
  const std::array balls{Ball{triangle.a, 0.0f}, Ball{triangle.b, 0.0f}, Ball{triangle.c, 0.0f}};
  if (closing == nullptr) return visit(balls);
  visit(std::array{balls[0], balls[1], balls[2], Ball{closing->a, 0.0f}, Ball{closing->b, 0.0f},
                   Ball{closing->c, 0.0f}});
}

template <class Visit>
void visit_cone_pieces(const Shapes& shapes, std::size_t i, Visit visit) {
  visit_pieces(shapes.cones[i], shapes.closing_cones.empty() ? nullptr : &shapes.closing_cones[i],
               visit);
}

template <class Visit>
void visit_triangle_pieces(const Shapes& shapes, Visit visit) {
  for (std::size_t i = 0; i < shapes.triangles.size(); ++i)
    visit_pieces(shapes.triangles[i],
                 shapes.closing_triangles.empty() ? nullptr : &shapes.closing_triangles[i], visit);
}

/// Calls `visit` with the box around each patch of up to eight consecutive triangles.
template <class Visit>
void visit_patch_boxes(const Shapes& shapes, Visit visit) {
  const std::size_t count = shapes.triangles.size();
  for (std::size_t first = 0; first < count; first += patch_size) {
    Box box = box_of(shapes.triangles[first]);
    for (std::size_t i = first; i < std::min(first + patch_size, count); ++i) {
      box = hull(box, box_of(shapes.triangles[i]));
      if (!shapes.closing_triangles.empty()) box = hull(box, box_of(shapes.closing_triangles[i]));
    }
    visit(box);
  }
}

template <class Visit>
void visit_pieces(const Shapes& shapes, Visit visit) {
  for (std::size_t i = 0; i < shapes.cones.size(); ++i) visit_cone_pieces(shapes, i, visit);
  visit_triangle_pieces(shapes, visit);
}

}  // namespace mien::render
