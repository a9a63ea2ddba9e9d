#pragma once

#include <optional>
#include <span>

#include "motion/math/geometry.h"

namespace mien::motion {

/// A rotation followed by a translation.
struct Placement {
  Quat rotation = Quat::Identity();
  Vec3 position = Vec3::Zero();

  Vec3 operator*(const Vec3& point) const { return position + rotation * point; }
};

/// The placement that takes the points of a rigid shape as near as possible (least squares) to
/// where they were measured (Kabsch 1976). None if there are fewer than three points or they lie
/// nearly on a line.
std::optional<Placement> rigid_placement(std::span<const Vec3> shape,
                                         std::span<const Vec3> measured);

}  // namespace mien::motion
