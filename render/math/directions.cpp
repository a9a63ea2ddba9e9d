#include "render/math/directions.h"

#include <algorithm>
#include <cmath>

#include "render/math/constants.h"

namespace mien::render {
namespace {

// Point on the unit circle at `eighths`·π/4, −1 … 1. Chebyshev fits, error below 4e-8.
DiscPoint on_arc(float eighths) {
  const float angle = eighths * (pi / 4.0f);
  const float z = angle * angle;
  const float cosine =
      1.0f + z * (-0.5f + z * (0.04166661575f + z * (-0.001388661796f + z * 2.437983e-05f)));
  const float sine =
      angle * (1.0f + z * (-0.1666665077f + z * (0.008332035504f + z * -1.9503904e-04f)));
  return {cosine, sine};
}

Vec3 around(const Vec3& normal, float x, float y, float z) {
  const Tangents frame = tangents(normal);
  return (x * frame.a + y * frame.b + z * normal).normalized();
}

}  // namespace

DiscPoint disc_point(Point2 u) {
  const float x = 2.0f * u.u - 1.0f;
  const float y = 2.0f * u.v - 1.0f;
  if (x == 0.0f && y == 0.0f) return {0.0f, 0.0f};
  if (std::abs(x) > std::abs(y)) {
    const DiscPoint p = on_arc(y / x);
    return {x * p.x, x * p.y};
  }
  const DiscPoint p = on_arc(x / y);
  return {y * p.y, y * p.x};
}

float arc_sine(float x) {
  const bool upper = x > 0.5f;
  const float z = upper ? 0.5f * (1.0f - x) : x * x;
  const float s = upper ? std::sqrt(std::max(z, 0.0f)) : x;
  const float series =
      s * (1.0f + z * (0.166667819f +
                       z * (0.0749469697f +
                            z * (0.0455206372f + z * (0.0239939988f + z * 0.0424173735f)))));
  return upper ? 0.5f * pi - 2.0f * series : series;
}

Tangents tangents(const Vec3& n) {
  const float sign = std::copysign(1.0f, n.z());
  const float a = -1.0f / (sign + n.z());
  const float b = n.x() * n.y() * a;
  return {{1.0f + sign * n.x() * n.x() * a, sign * b, -sign * n.x()},
          {b, sign + n.y() * n.y() * a, -n.y()}};
}

Vec3 cosine_direction(const Vec3& normal, Point2 u) {
  const DiscPoint p = disc_point(u);
  return around(normal, p.x, p.y, std::sqrt(std::max(0.0f, 1.0f - p.x * p.x - p.y * p.y)));
}

Vec3 cone_direction(const Vec3& axis, float cosine_of_half_angle, Point2 u) {
  const DiscPoint p = disc_point(u);
  // The squared radius is uniform, hence so is the height it is mapped to (Archimedes).
  const float squared = p.x * p.x + p.y * p.y;
  const float drop = squared * (1.0f - cosine_of_half_angle);
  const float spread = std::sqrt((1.0f - cosine_of_half_angle) * (2.0f - drop));
  return around(axis, p.x * spread, p.y * spread, 1.0f - drop);
}

}  // namespace mien::render
