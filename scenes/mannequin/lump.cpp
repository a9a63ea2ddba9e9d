#include "scenes/mannequin/lump.h"

#include <algorithm>
#include <cmath>

namespace mien::scenes {

namespace {

using motion::Vec3;

constexpr double cut_rounding = 0.012;  // metres
constexpr double far_away = 1e3;

double distance_to_ellipsoid(const Lump& lump, const Vec3& point) {
  const Vec3 local = lump.axes.transpose() * (point - lump.start);
  const Vec3 scaled = local.cwiseQuotient(lump.radii);
  const double gradient = scaled.cwiseQuotient(lump.radii).norm();
  const double level = scaled.norm();
  if (gradient < 1e-9) return -lump.radii.minCoeff();
  return std::max(level * (level - 1.0) / gradient, local.norm() - lump.radii.maxCoeff());
}

/// After Quilez, "Round cone": the nearest of the two balls and the cone that touches both.
double distance_to_round_cone(const Lump& lump, const Vec3& point) {
  const Vec3 axis = lump.end - lump.start;
  const double length_squared = axis.squaredNorm();
  const double narrowing = lump.start_radius - lump.end_radius;
  const double slant_squared = length_squared - narrowing * narrowing;
  const Vec3 from_start = point - lump.start;
  if (slant_squared <= 0.0) {
    return std::min(from_start.norm() - lump.start_radius,
                    (point - lump.end).norm() - lump.end_radius);
  }
  const double along = from_start.dot(axis);
  const double beyond = along - length_squared;
  const double across = (from_start * length_squared - axis * along).squaredNorm();
  const double along_squared = along * along * length_squared;
  const double beyond_squared = beyond * beyond * length_squared;
  const double k = std::copysign(narrowing * narrowing * across, narrowing);
  const double inverse = 1.0 / length_squared;
  if (std::copysign(slant_squared * beyond_squared, beyond) > k) {
    return std::sqrt(across + beyond_squared) * inverse - lump.end_radius;
  }
  if (std::copysign(slant_squared * along_squared, along) < k) {
    return std::sqrt(across + along_squared) * inverse - lump.start_radius;
  }
  return (std::sqrt(across * slant_squared * inverse) + along * narrowing) * inverse -
         lump.start_radius;
}

/// No distance to the lump is less.
double least_distance(const Lump& lump, const Vec3& point) {
  if (lump.shape == Lump::Shape::ellipsoid) {
    return (point - lump.start).norm() - lump.radii.maxCoeff();
  }
  return (point - 0.5 * (lump.start + lump.end)).norm() - 0.5 * (lump.end - lump.start).norm() -
         std::max(lump.start_radius, lump.end_radius);
}

}  // namespace

double smooth_minimum(double a, double b, double blend) {
  const double overlap = std::max(blend - std::abs(a - b), 0.0);
  if (overlap == 0.0) return std::min(a, b);
  return std::min(a, b) - overlap * overlap / (4.0 * blend);
}

double signed_distance(const Lump& lump, const Vec3& point) {
  const double distance = lump.shape == Lump::Shape::ellipsoid
                              ? distance_to_ellipsoid(lump, point)
                              : distance_to_round_cone(lump, point);
  if (!lump.within) return distance;
  const double outside = -lump.within->inward.dot(point - lump.within->point);
  return -smooth_minimum(-distance, -outside, cut_rounding);
}

double signed_distance(std::span<const Lump> lumps, const Vec3& point) {
  double distance = far_away;
  for (const Lump& lump : lumps) {
    if (least_distance(lump, point) > distance + lump.blend) continue;
    distance = smooth_minimum(distance, signed_distance(lump, point), lump.blend);
  }
  return distance;
}

}  // namespace mien::scenes
