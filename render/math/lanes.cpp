#include "render/math/lanes.h"

#include <cmath>

#include "render/math/directions.h"
#include "render/math/for_avx2.h"
#include "render/math/sampler.h"

namespace mien::render {
namespace {

struct Direction {
  float x;
  float y;
  float z;
};

// (x, y, z) in the frame of a unit normal (Duff et al. 2017).
inline Direction about(float nx, float ny, float nz, float x, float y, float z) {
  const float sign = nz >= 0.0f ? 1.0f : -1.0f;
  const float a = -1.0f / (sign + nz);
  const float b = nx * ny * a;
  const float dx = x * (1.0f + sign * nx * nx * a) + y * b + z * nx;
  const float dy = x * (sign * b) + y * (sign + ny * ny * a) + z * ny;
  const float dz = x * (-sign * nx) + y * (-ny) + z * nz;
  const float scale = 1.0f / std::sqrt(dx * dx + dy * dy + dz * dz);
  return {dx * scale, dy * scale, dz * scale};
}

}  // namespace

MIEN_FOR_AVX2_TOO LanePoints sample_points(const LaneWords& index, const LaneWords& seed) {
  LanePoints points;
#pragma omp simd
  for (unsigned i = 0; i < lanes; ++i) {
    const Point2 point = sample_point(index.lane[i], seed.lane[i]);
    points.u.lane[i] = point.u;
    points.v.lane[i] = point.v;
  }
  return points;
}

MIEN_FOR_AVX2_TOO LaneVectors cosine_directions(const LaneVectors& normal, const LanePoints& u) {
  LaneVectors out;
#pragma omp simd
  for (unsigned i = 0; i < lanes; ++i) {
    const DiscPoint p = disc_point({u.u.lane[i], u.v.lane[i]});
    const float rest = 1.0f - p.x * p.x - p.y * p.y;
    const Direction d = about(normal.x.lane[i], normal.y.lane[i], normal.z.lane[i], p.x, p.y,
                              std::sqrt(rest > 0.0f ? rest : 0.0f));
    out.x.lane[i] = d.x;
    out.y.lane[i] = d.y;
    out.z.lane[i] = d.z;
  }
  return out;
}

MIEN_FOR_AVX2_TOO LaneSphereRays rays_to_sphere(const Vec3& centre, float radius,
                                                const LaneVectors& point, const LaneVectors& normal,
                                                const LanePoints& u) {
  LaneSphereRays out;
  const float cx = centre.x(), cy = centre.y(), cz = centre.z();
#pragma omp simd
  for (unsigned i = 0; i < lanes; ++i) {
    const float nx = normal.x.lane[i], ny = normal.y.lane[i], nz = normal.z.lane[i];
    const float x = cx - point.x.lane[i], y = cy - point.y.lane[i], z = cz - point.z.lane[i];
    const float squared = x * x + y * y + z * z;
    const float sine_squared = radius * radius / squared;
    const bool narrow = sine_squared < greatest_cone_sine_squared;
    const float scale = narrow ? 1.0f / std::sqrt(squared) : 0.0f;
    const float height = 1.0f - std::sqrt(narrow ? 1.0f - sine_squared : 0.0f);
    const DiscPoint p = disc_point({u.u.lane[i], u.v.lane[i]});
    const float disc = p.x * p.x + p.y * p.y;
    const float drop = disc * height;
    const float spread = narrow ? std::sqrt(height * (2.0f - drop)) : 1.0f;
    const float rest = 1.0f - disc > 0.0f ? 1.0f - disc : 0.0f;
    const float up = narrow ? 1.0f - drop : std::sqrt(rest);
    const Direction d = about(narrow ? x * scale : nx, narrow ? y * scale : ny,
                              narrow ? z * scale : nz, p.x * spread, p.y * spread, up);
    out.towards.x.lane[i] = d.x;
    out.towards.y.lane[i] = d.y;
    out.towards.z.lane[i] = d.z;
    const float cosine = d.x * nx + d.y * ny + d.z * nz;
    out.share.lane[i] = narrow ? 2.0f * height * cosine : 1.0f;
  }
  return out;
}

}  // namespace mien::render
