#include "scenes/mannequin/sdf_primitive.h"

#include <algorithm>
#include <cmath>

namespace mien::scenes {

namespace {

using motion::Vec3;

constexpr double cut_rounding = 0.012;  // metres
constexpr double far_away = 1e3;

double distance_to_ellipsoid(const SdfPrimitive& primitive, const Vec3& point) {
  const Vec3 local = primitive.axes.transpose() * (point - primitive.start);
  const Vec3 scaled = local.cwiseQuotient(primitive.radii);
  const double gradient = scaled.cwiseQuotient(primitive.radii).norm();
  const double level = scaled.norm();
  if (gradient < 1e-9) return -primitive.radii.minCoeff();
  return std::max(level * (level - 1.0) / gradient, local.norm() - primitive.radii.maxCoeff());
}

/// After Quilez, "Round cone": the nearest of the two balls and the cone that touches both.
double distance_to_round_cone(const SdfPrimitive& primitive, const Vec3& point) {
  const Vec3 axis = primitive.end - primitive.start;
  const double length_squared = axis.squaredNorm();
  const double narrowing = primitive.start_radius - primitive.end_radius;
  const double slant_squared = length_squared - narrowing * narrowing;
  const Vec3 from_start = point - primitive.start;
  if (slant_squared <= 0.0) {
    return std::min(from_start.norm() - primitive.start_radius,
                    (point - primitive.end).norm() - primitive.end_radius);
  }
  const double along = from_start.dot(axis);
  const double beyond = along - length_squared;
  const double across = (from_start * length_squared - axis * along).squaredNorm();
  const double along_squared = along * along * length_squared;
  const double beyond_squared = beyond * beyond * length_squared;
  const double k = std::copysign(narrowing * narrowing * across, narrowing);
  const double inverse = 1.0 / length_squared;
  if (std::copysign(slant_squared * beyond_squared, beyond) > k) {
    return std::sqrt(across + beyond_squared) * inverse - primitive.end_radius;
  }
  if (std::copysign(slant_squared * along_squared, along) < k) {
    return std::sqrt(across + along_squared) * inverse - primitive.start_radius;
  }
  return (std::sqrt(across * slant_squared * inverse) + along * narrowing) * inverse -
         primitive.start_radius;
}

/// A lower bound of the distance to the primitive.
double distance_lower_bound(const SdfPrimitive& primitive, const Vec3& point) {
  if (primitive.shape == SdfPrimitive::Shape::ellipsoid) {
    return (point - primitive.start).norm() - primitive.radii.maxCoeff();
  }
  return (point - 0.5 * (primitive.start + primitive.end)).norm() -
         0.5 * (primitive.end - primitive.start).norm() -
         std::max(primitive.start_radius, primitive.end_radius);
}

}  // namespace

double smooth_minimum(double a, double b, double blend) {
  const double overlap = std::max(blend - std::abs(a - b), 0.0);
  if (overlap == 0.0) return std::min(a, b);
  return std::min(a, b) - overlap * overlap / (4.0 * blend);
}

double signed_distance(const SdfPrimitive& primitive, const Vec3& point) {
  const double distance = primitive.shape == SdfPrimitive::Shape::ellipsoid
                              ? distance_to_ellipsoid(primitive, point)
                              : distance_to_round_cone(primitive, point);
  if (!primitive.within) return distance;
  const double outside = -primitive.within->inward.dot(point - primitive.within->point);
  return -smooth_minimum(-distance, -outside, cut_rounding);
}

double signed_distance(std::span<const SdfPrimitive> primitives, const Vec3& point) {
  double distance = far_away;
  for (const SdfPrimitive& primitive : primitives) {
    if (distance_lower_bound(primitive, point) > distance + primitive.blend) continue;
    distance = smooth_minimum(distance, signed_distance(primitive, point), primitive.blend);
  }
  return distance;
}

}  // namespace mien::scenes
