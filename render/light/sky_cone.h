#pragma once

#include <optional>

#include "render/geometry/reach.h"
#include "render/math/sampler.h"
#include "render/math/vector.h"

namespace mien::render {

// How rays are spent on the sky that a figure hides from a surface.

/// The directions from a point that may meet the figure, where they are few.
struct Cone {
  Vec3 axis;     ///< unit
  float cosine;  ///< of its half angle

  float solid_angle() const;
};

/// Square of the sine of the half angle that such a cone has at most.
inline constexpr float greatest_cone_sine_squared = 0.6f;

/// Around a bounding sphere; nothing when that fills half of what the point sees or more.
std::optional<Cone> cone_of(const BoundingSphere& bounds, const Vec3& point);

/// The first `rays` of a pixel's samples look at the sky, and each stands for `samples`.
struct SkyRays {
  int rays = 0;
  float samples = 0.0f;
};

/// So many as a pixel of `samples` is worth that shows a surface at `point`. Where that is less
/// than one ray, there is one by chance.
SkyRays sky_rays_of(const BoundingSphere& bounds, const Vec3& point, const Vec3& normal,
                    int samples, const PixelSampler& sampler);

}  // namespace mien::render
