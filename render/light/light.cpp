#include "render/light/light.h"

#include <array>
#include <cmath>
#include <numbers>

#include "render/math/for_avx2.h"

namespace mien::render {
namespace {

constexpr float half_pi = std::numbers::pi_v<float> / 2.0f;

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

MIEN_FOR_AVX2_TOO LaneLights sample(const AreaLight& light, const LaneVectors& point,
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
    : front(light.half_u.cross(light.half_v)), centre(light.centre) {
  const Vec3 &u = light.half_u, &v = light.half_v;
  const std::array<Vec3, 4> whole = {centre - u - v, centre - u + v, centre + u + v,
                                     centre + u - v};
  for (std::size_t i = 0; i < whole.size(); ++i) {
    const Vec3 &here = whole[i], &next = whole[(i + 1) % whole.size()];
    const float height = here.y(), next_height = next.y();
    if (height >= 0.0f) corners.push_back(here);
    if ((height < 0.0f) != (next_height < 0.0f))
      corners.push_back(here + (height / (height - next_height)) * (next - here));
  }
}

std::vector<float> numbers_of(const AreaLight& light) {
  std::vector<float> numbers;
  for (const float* each :
       {light.centre.data(), light.half_u.data(), light.half_v.data(), light.radiance.data()})
    numbers.insert(numbers.end(), each, each + 3);
  return numbers;
}

// The horizon of a floor that faces up is the floor itself, so the light is cut once for all
// points. Of each edge, from a to b as seen from the point, Lambert's formula takes the angle
// between them times how much of the unit normal a × b / |a × b| is upwards; the angle's tangent is
// |a × b| / a · b.
MIEN_FOR_AVX2_TOO LaneFloats irradiance(const FloorLight& light, const LaneVectors& point) {
  LaneFloats out;
  if (light.corners.size() < 3) return out;
  const float fx = light.front.x(), fy = light.front.y(), fz = light.front.z();
  const float cx = light.centre.x(), cy = light.centre.y(), cz = light.centre.z();
  LaneFloats sum;
  for (std::size_t k = 0; k < light.corners.size(); ++k) {
    const Vec3& from = k == 0 ? light.corners.back() : light.corners[k - 1];
    const Vec3& to = light.corners[k];
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
