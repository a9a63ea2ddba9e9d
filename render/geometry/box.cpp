#include "render/geometry/box.h"

#include <algorithm>

namespace mien::render {

Box box_of(const PreparedCone& cone) {
  const Eigen::Array3f a = cone.a.array(), b = cone.b().array();
  return {(a - cone.radius_a).min(b - cone.radius_b), (a + cone.radius_a).max(b + cone.radius_b)};
}

Box box_of(const Triangle& triangle) {
  const Eigen::Array3f a = triangle.a.array(), b = triangle.b.array(), c = triangle.c.array();
  return {a.min(b).min(c), a.max(b).max(c)};
}

Box hull(const Box& a, const Box& b) { return {a.lower.min(b.lower), a.upper.max(b.upper)}; }

Box padded(const Box& box) {
  const float padding =
      1e-4f * std::max(1.0f, std::max(box.lower.abs().maxCoeff(), box.upper.abs().maxCoeff()));
  return {box.lower - padding, box.upper + padding};
}

}  // namespace mien::render
