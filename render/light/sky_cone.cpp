#include "render/light/sky_cone.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "render/math/constants.h"

namespace mien::render {
namespace {

// Where the figure covers little of the sky, few rays from a surface are enough. So many that the
// noise stays below `sky_noise` of the sky's light, when a figure fills about a ninth of the sphere
// round it; and so many that one ray that is blocked takes away no more than `sky_share_of_a_ray`.
constexpr float sky_noise = 0.02f;
constexpr float sky_share_of_a_ray = 0.05f;
constexpr float figure_deviation = 0.32f;  // of a ray that is blocked one time in nine

// The most that one ray within the cone can stand for, as a share of the sky over a surface.
float greatest_share(const Cone& cone, const Vec3& normal) {
  const float sine = std::sqrt(1.0f - cone.cosine * cone.cosine);
  const float elevation_sine = cone.axis.dot(normal);
  const float elevation_cosine = std::sqrt(std::max(0.0f, 1.0f - elevation_sine * elevation_sine));
  const float highest = elevation_sine * cone.cosine + elevation_cosine * sine;
  return cone.solid_angle() / pi * std::clamp(highest, 0.0f, 1.0f);
}

// How many rays a pixel is worth; below 1, the chance of one.
float sky_rays_from(const BoundingSphere& bounds, const Vec3& point, const Vec3& normal, int most) {
  const std::optional<Cone> cone = cone_of(bounds, point);
  if (!cone) return static_cast<float>(most);
  const float share = greatest_share(*cone, normal);
  const float quiet = share * figure_deviation / sky_noise;
  return std::min(std::max(quiet * quiet, share / sky_share_of_a_ray), static_cast<float>(most));
}

}  // namespace

float Cone::solid_angle() const { return 2.0f * pi * (1.0f - cosine); }

std::optional<Cone> cone_of(const BoundingSphere& bounds, const Vec3& point) {
  const Vec3 towards = bounds.centre - point;
  const float squared = towards.squaredNorm();
  const float sine_squared = bounds.radius * bounds.radius / squared;
  if (!(sine_squared < greatest_cone_sine_squared)) return std::nullopt;
  return Cone{towards / std::sqrt(squared), std::sqrt(1.0f - sine_squared)};
}

SkyRays sky_rays_of(const BoundingSphere& bounds, const Vec3& point, const Vec3& normal,
                    int samples, const PixelSampler& sampler) {
  const float wanted = sky_rays_from(bounds, point, normal, samples);
  const auto all = static_cast<float>(samples);
  if (wanted < 1.0f) {
    const bool chosen = sampler.choice(Dimension::FloorSkyChoice) < wanted;
    return {chosen ? 1 : 0, all / wanted};
  }
  // A power of two: such a block of the sequence is well spread.
  const auto rays = static_cast<unsigned>(std::ceil(wanted));
  const int first = std::min(static_cast<int>(std::bit_ceil(rays)), samples);
  return {first, all / static_cast<float>(first)};
}

}  // namespace mien::render
