#pragma once

#include <optional>

#include "render/geometry/bounding_volumes.h"
#include "render/math/sampler.h"
#include "render/math/vector.h"

namespace mien::render {

// Sampling of the sky's occlusion by a figure.

/// The directions from a point that may meet the figure, where they are few.
struct Cone {
  Vec3 axis;     ///< unit
  float cosine;  ///< of its half angle

  float solid_angle() const;
};

/// Upper bound of the squared sine of the half angle of a Cone.
inline constexpr float greatest_cone_sine_squared = 0.6f;

/// The cone around a bounding sphere; nothing when that fills half of the point's hemisphere or
/// more.
std::optional<Cone> cone_of(const BoundingSphere& bounds, const Vec3& point);

/// How many of a pixel's samples, the first ones, cast a ray at the sky, and how many samples each
/// represents.
struct SkyRays {
  int rays = 0;
  float samples = 0.0f;
};

/// Rays for a pixel of `samples` that shows a surface at `point`, in proportion to the solid angle
/// of the figure; an expectation below one ray is met by Russian roulette.
SkyRays sky_rays_of(const BoundingSphere& bounds, const Vec3& point, const Vec3& normal,
                    int samples, const PixelSampler& sampler);

}  // namespace mien::render
