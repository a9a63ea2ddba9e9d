#include "render/light/lanes.h"

#include <cmath>
#include <numbers>

#include "render/light/sky_cone.h"
#include "render/math/for_avx2.h"
#include "render/math/sampler.h"

namespace mien::render {
namespace {

constexpr float quarter_pi = std::numbers::pi_v<float> / 4.0f;
constexpr float half_pi = std::numbers::pi_v<float> / 2.0f;

struct Disc {
  float x;
  float y;
};

// As disc_point, without branches.
inline Disc on_disc(float u, float v) {
  const float x = 2.0f * u - 1.0f, y = 2.0f * v - 1.0f;
  const bool wide = std::abs(x) > std::abs(y);
  const float radius = wide ? x : y;
  const float other = wide ? y : x;
  const float angle = radius == 0.0f ? 0.0f : other / radius * quarter_pi;
  const float z = angle * angle;
  const float cosine =
      1.0f + z * (-0.5f + z * (0.04166661575f + z * (-0.001388661796f + z * 2.437983e-05f)));
  const float sine =
      angle * (1.0f + z * (-0.1666665077f + z * (0.008332035504f + z * -1.9503904e-04f)));
  const float along = radius * cosine, across = radius * sine;
  return {wide ? along : across, wide ? across : along};
}

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

// atan(√z) / √z for z in [0, 1], with a relative error of at most 1e-7: our own Chebyshev
// approximation.
inline float arc_tangent_ratio(float z) {
  return 1.0f +
         z * (-0.33333066f +
              z * (0.19992484f +
                   z * (-0.14202571f +
                        z * (0.10636754f +
                             z * (-0.07495446f +
                                  z * (0.042587608f + z * (-0.01600503f + z * 0.0028340644f)))))));
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

MIEN_FOR_AVX2_TOO void camera_rays(const CameraFrame& camera, const LaneFloats& x,
                                   const LaneFloats& y, LaneVectors& origin,
                                   LaneVectors& direction) {
  const bool parallel = camera.parallel;
  // What a camera's rays have in common, and what of it grows from the middle of the film.
  const float all = parallel ? 0.0f : 1.0f, some = parallel ? 1.0f : 0.0f;
  const float px = camera.position.x(), py = camera.position.y(), pz = camera.position.z();
  const float fx = camera.forward.x(), fy = camera.forward.y(), fz = camera.forward.z();
  const float rx = camera.step_right.x(), ry = camera.step_right.y(), rz = camera.step_right.z();
  const float sx = camera.step_down.x(), sy = camera.step_down.y(), sz = camera.step_down.z();
  const float centre_x = camera.centre_x, centre_y = camera.centre_y;
#pragma omp simd
  for (unsigned i = 0; i < lanes; ++i) {
    const float u = x.lane[i] - centre_x, v = y.lane[i] - centre_y;
    const float ax = u * rx + v * sx, ay = u * ry + v * sy, az = u * rz + v * sz;
    const float dx = fx + all * ax, dy = fy + all * ay, dz = fz + all * az;
    const float scale = 1.0f / std::sqrt(dx * dx + dy * dy + dz * dz);
    origin.x.lane[i] = px + some * ax;
    origin.y.lane[i] = py + some * ay;
    origin.z.lane[i] = pz + some * az;
    direction.x.lane[i] = dx * scale;
    direction.y.lane[i] = dy * scale;
    direction.z.lane[i] = dz * scale;
  }
}

MIEN_FOR_AVX2_TOO LaneVectors cosine_directions(const LaneVectors& normal, const LanePoints& u) {
  LaneVectors out;
#pragma omp simd
  for (unsigned i = 0; i < lanes; ++i) {
    const Disc p = on_disc(u.u.lane[i], u.v.lane[i]);
    const float rest = 1.0f - p.x * p.x - p.y * p.y;
    const Direction d = about(normal.x.lane[i], normal.y.lane[i], normal.z.lane[i], p.x, p.y,
                              std::sqrt(rest > 0.0f ? rest : 0.0f));
    out.x.lane[i] = d.x;
    out.y.lane[i] = d.y;
    out.z.lane[i] = d.z;
  }
  return out;
}

MIEN_FOR_AVX2_TOO LaneVectors cone_directions(const Vec3& axis, float cosine_of_half_angle,
                                              const LanePoints& u) {
  LaneVectors out;
  const float ax = axis.x(), ay = axis.y(), az = axis.z();
  const float height = 1.0f - cosine_of_half_angle;
#pragma omp simd
  for (unsigned i = 0; i < lanes; ++i) {
    const Disc p = on_disc(u.u.lane[i], u.v.lane[i]);
    const float drop = (p.x * p.x + p.y * p.y) * height;
    const float spread = std::sqrt(height * (2.0f - drop));
    const Direction d = about(ax, ay, az, p.x * spread, p.y * spread, 1.0f - drop);
    out.x.lane[i] = d.x;
    out.y.lane[i] = d.y;
    out.z.lane[i] = d.z;
  }
  return out;
}

MIEN_FOR_AVX2_TOO LaneSkyRays floor_sky_rays(const Vec3& centre, float radius,
                                             const LaneVectors& point, const LanePoints& u) {
  LaneSkyRays out;
  const float cx = centre.x(), cy = centre.y(), cz = centre.z();
#pragma omp simd
  for (unsigned i = 0; i < lanes; ++i) {
    const float x = cx - point.x.lane[i], y = cy - point.y.lane[i], z = cz - point.z.lane[i];
    const float squared = x * x + y * y + z * z;
    const float sine_squared = radius * radius / squared;
    const bool few = sine_squared < greatest_cone_sine_squared;
    const float scale = few ? 1.0f / std::sqrt(squared) : 0.0f;
    const float height = 1.0f - std::sqrt(few ? 1.0f - sine_squared : 0.0f);
    const Disc p = on_disc(u.u.lane[i], u.v.lane[i]);
    const float disc = p.x * p.x + p.y * p.y;
    const float drop = disc * height;
    const float spread = few ? std::sqrt(height * (2.0f - drop)) : 1.0f;
    const float rest = 1.0f - disc > 0.0f ? 1.0f - disc : 0.0f;
    const float up = few ? 1.0f - drop : std::sqrt(rest);
    const Direction d =
        about(x * scale, few ? y * scale : 1.0f, z * scale, p.x * spread, p.y * spread, up);
    out.towards.x.lane[i] = d.x;
    out.towards.y.lane[i] = d.y;
    out.towards.z.lane[i] = d.z;
    out.share.lane[i] = few ? 2.0f * height * d.y : 1.0f;
  }
  return out;
}

MIEN_FOR_AVX2_TOO LaneLights sample_lights(const AreaLight& light, const LaneVectors& point,
                                           const LanePoints& u) {
  LaneLights out;
  const Vec3 &centre = light.centre, &a = light.half_u, &b = light.half_v;
  // Its length is the light's area.
  const Vec3 area = 4.0f * a.cross(b);
#pragma omp simd
  for (unsigned i = 0; i < lanes; ++i) {
    const float s = 2.0f * u.u.lane[i] - 1.0f, t = 2.0f * u.v.lane[i] - 1.0f;
    const float x = centre.x() + s * a.x() + t * b.x() - point.x.lane[i];
    const float y = centre.y() + s * a.y() + t * b.y() - point.y.lane[i];
    const float z = centre.z() + s * a.z() + t * b.z() - point.z.lane[i];
    const float squared = x * x + y * y + z * z;
    const float distance = std::sqrt(squared);
    const float scale = 1.0f / distance;
    const float facing = -(area.x() * x + area.y() * y + area.z() * z) * scale;
    out.towards.x.lane[i] = x * scale;
    out.towards.y.lane[i] = y * scale;
    out.towards.z.lane[i] = z * scale;
    out.distance.lane[i] = distance;
    out.share.lane[i] = facing > 0.0f ? facing / squared : 0.0f;
  }
  return out;
}

FloorLight::FloorLight(const AreaLight& light)
    : front_(light.half_u.cross(light.half_v)), centre_(light.centre) {
  const Vec3 &centre = light.centre, &u = light.half_u, &v = light.half_v;
  const Vec3 corners[4] = {centre - u - v, centre - u + v, centre + u + v, centre + u - v};
  for (int i = 0; i < 4; ++i) {
    const Vec3 &here = corners[i], &next = corners[(i + 1) % 4];
    const float height = here.y(), next_height = next.y();
    if (height >= 0.0f) add(here);
    if ((height < 0.0f) != (next_height < 0.0f))
      add(here + (height / (height - next_height)) * (next - here));
  }
}

// The horizon of a floor that faces up is the floor itself, so the light is cut once for all
// points. Of each edge, from a to b as seen from the point, Lambert's formula takes the angle
// between them times how much of the unit normal a × b / |a × b| is upwards; the angle's tangent is
// |a × b| / a · b.
MIEN_FOR_AVX2_TOO LaneFloats light_on_floor(const FloorLight& light, const LaneVectors& point) {
  LaneFloats out;
  if (light.count() < 3) return out;
  const float fx = light.front().x(), fy = light.front().y(), fz = light.front().z();
  const float cx = light.centre().x(), cy = light.centre().y(), cz = light.centre().z();
  LaneFloats sum;
  for (int k = 0; k < light.count(); ++k) {
    const Vec3& from = light.corner(k == 0 ? light.count() - 1 : k - 1);
    const Vec3& to = light.corner(k);
    const float from_x = from.x(), from_y = from.y(), from_z = from.z();
    const float to_x = to.x(), to_y = to.y(), to_z = to.z();
#pragma omp simd
    for (unsigned i = 0; i < lanes; ++i) {
      const float px = point.x.lane[i], py = point.y.lane[i], pz = point.z.lane[i];
      const float ax = from_x - px, ay = from_y - py, az = from_z - pz;
      const float bx = to_x - px, by = to_y - py, bz = to_z - pz;
      const float nx = ay * bz - az * by, ny = az * bx - ax * bz, nz = ax * by - ay * bx;
      const float sine = std::sqrt(nx * nx + ny * ny + nz * nz);
      const float cosine = ax * bx + ay * by + az * bz;
      const float size = cosine < 0.0f ? -cosine : cosine;
      const bool steep = sine > size;
      const float tangent = (steep ? size : sine) / (steep ? sine : size);
      const float flat = tangent * arc_tangent_ratio(tangent * tangent);
      const float acute = steep ? half_pi - flat : flat;
      const float angle = cosine < 0.0f ? 2.0f * half_pi - acute : acute;
      // Where a and b are all but one the ratio is that of their lengths.
      const float by_sine = sine > 1e-6f * size ? angle / sine : 1.0f / size;
      sum.lane[i] += by_sine * ny;
    }
  }
#pragma omp simd
  for (unsigned i = 0; i < lanes; ++i) {
    const float px = point.x.lane[i], py = point.y.lane[i], pz = point.z.lane[i];
    const bool is_behind = fx * (cx - px) + fy * (cy - py) + fz * (cz - pz) >= 0.0f;
    out.lane[i] = is_behind | !(sum.lane[i] > 0.0f) ? 0.0f : 0.5f * sum.lane[i];
  }
  return out;
}

}  // namespace mien::render
