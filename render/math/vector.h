#pragma once

#include <Eigen/Geometry>

namespace mien::render {

/// A point (metres) or direction in world space: right-handed, +Y up, the floor at y = 0.
using Vec3 = Eigen::Vector3f;

/// A linear colour, Rec.709 primaries: an albedo, a radiance or a pixel, as stated where it is
/// declared.
using Color = Eigen::Array3f;

}  // namespace mien::render
