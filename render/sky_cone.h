#pragma once

#include <optional>

#include "render/reach.h"
#include "render/vector.h"

namespace mien::render {

// How rays are spent on the sky that a figure hides from a surface.

/// The directions from a point that may meet the figure, where they are few.
struct Cone {
  Vec3 axis;     ///< unit
  float cosine;  ///< of its half angle

  float solid_angle() const;
};

/// Around a bounding sphere; nothing when that fills half of what the point sees or more.
std::optional<Cone> cone_of(const BoundingSphere& bounds, const Vec3& point);

/// How many rays a pixel of the floor is worth that shows `point`; below 1, the chance of one. At
/// most `most`.
float sky_rays_from(const BoundingSphere& bounds, const Vec3& point, int most);

}  // namespace mien::render
