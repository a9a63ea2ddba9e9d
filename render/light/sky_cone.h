#pragma once

#include <optional>

#include "render/geometry/bounding_volumes.h"
#include "render/math/lanes.h"
#include "render/math/sampler.h"

namespace mien::render {

// Sampling of a figure's occlusion of the sky (see rays_to_sphere).

/// A cone of directions from a point that contains the whole figure.
struct Cone {
  Vec3 axis;     ///< unit
  float cosine;  ///< cosine of the half angle

  float solid_angle() const;
};

/// Returns the cone around a bounding sphere; nothing if the squared sine of its half angle is
/// greatest_cone_sine_squared or more, which includes points inside the sphere.
std::optional<Cone> cone_of(const BoundingSphere& bounds, const Vec3& point);

/// The sky rays of a pixel.
struct SkyRays {
  int rays = 0;          ///< the first `rays` of its samples cast one each
  float samples = 0.0f;  ///< number of samples that each of them stands for
};

/// Returns the sky rays of a pixel of `samples` samples that shows a surface at `point`; their
/// number grows with the solid angle of the figure. An expected number below one is realised by
/// Russian roulette.
SkyRays sky_rays_of(const BoundingSphere& bounds, const Vec3& point, const Vec3& normal,
                    int samples, const PixelSampler& sampler);

}  // namespace mien::render
