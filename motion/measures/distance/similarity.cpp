#include "motion/measures/distance/similarity.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "motion/math/singular_values.h"
#include "motion/skeleton/mirror.h"

namespace mien::motion {

namespace {

Vec3 centre_of(std::span<const Vec3> points) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& point : points) sum += point;
  return sum / static_cast<double>(points.size());
}

/// Sums over the points, each from its centre.
struct Moments {
  Mat3 covariance = Mat3::Zero();  ///< Σ (to − centre)(from − centre)ᵀ
  double spread = 0.0;             ///< Σ |from − centre|²
};

Moments moments(std::span<const Vec3> from, const Vec3& from_centre, std::span<const Vec3> to,
                const Vec3& to_centre) {
  Moments sums;
  for (std::size_t i = 0; i < from.size(); ++i) {
    sums.covariance += (to[i] - to_centre) * (from[i] - from_centre).transpose();
    sums.spread += (from[i] - from_centre).squaredNorm();
  }
  return sums;
}

Vec3 turned_level(const Vec3& point, double radians) {
  const double c = std::cos(radians);
  const double s = std::sin(radians);
  return {c * point.x() + s * point.z(), point.y(), c * point.z() - s * point.x()};
}

}  // namespace

Similarity similarity_fit(std::span<const Vec3> from, std::span<const Vec3> to) {
  assert(from.size() == to.size() && !from.empty());
  Similarity fit;
  if (std::ranges::equal(from, to)) return fit;
  const Vec3 from_centre = centre_of(from);
  const Vec3 to_centre = centre_of(to);
  const Moments sums = moments(from, from_centre, to, to_centre);
  if (sums.spread > 0.0) {
    const SingularValues svd = singular_values(sums.covariance);
    Vec3 signs = Vec3::Ones();
    if (Mat3(svd.u).determinant() * Mat3(svd.v).determinant() < 0.0) signs.z() = -1.0;
    fit.rotation = svd.u * signs.asDiagonal() * svd.v.transpose();
    fit.scale = svd.values.dot(signs) / sums.spread;
  }
  fit.shift = to_centre - fit.scale * (fit.rotation * from_centre);
  return fit;
}

Vec3 HorizontalTransform::operator()(const Vec3& point) const {
  return turned_level(mirrored ? mirrored_place(point) : point, turn_radians) + shift;
}

HorizontalTransform horizontal_fit(std::span<const Vec3> from, std::span<const Vec3> to,
                                   bool mirrored) {
  assert(from.size() == to.size() && !from.empty());
  HorizontalTransform fit;
  fit.mirrored = mirrored;
  if (!mirrored && std::ranges::equal(from, to)) return fit;
  const auto seen = [&](const Vec3& point) { return mirrored ? mirrored_place(point) : point; };
  const Vec3 from_centre = seen(centre_of(from));
  const Vec3 to_centre = centre_of(to);
  double cosines = 0.0;
  double sines = 0.0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    const Vec3 a = seen(from[i]) - from_centre;
    const Vec3 b = to[i] - to_centre;
    cosines += b.x() * a.x() + b.z() * a.z();
    sines += b.x() * a.z() - b.z() * a.x();
  }
  fit.turn_radians = std::atan2(sines, cosines);
  fit.shift = to_centre - turned_level(from_centre, fit.turn_radians);
  return fit;
}

}  // namespace mien::motion
