#pragma once

#include <Eigen/Geometry>

namespace mien::render {

/// A point (metres) or direction in world space: right-handed, +Y up, the floor at y = 0.
using Vec3 = Eigen::Vector3f;

/// Linear light, Rec.709 primaries. Albedo, radiance or pixel: the name of the member says which.
using Color = Eigen::Array3f;

}  // namespace mien::render
