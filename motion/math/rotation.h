#pragma once

#include <array>

#include "motion/math/geometry.h"

namespace mien::motion {

/// Rotation vector (axis × angle, radians, angle ≤ π) of a unit quaternion.
Vec3 log(const Quat& rotation);

/// Unit quaternion of a rotation vector (radians).
Quat exp(const Vec3& rotation_vector);

/// Angle of the rotation that takes `from` to `to`, radians in [0, π].
double angle_between(const Quat& from, const Quat& to);

/// Shortest-arc spherical interpolation; t = 0 gives `from`, t = 1 gives `to` (up to sign).
Quat slerp(const Quat& from, const Quat& to, double t);

/// `rotation` or its negative, whichever has a non-negative dot product with `reference`.
Quat in_hemisphere_of(const Quat& reference, const Quat& rotation);

/// The shortest rotation that takes the direction of `from` to that of `to`. Neither is zero; the
/// axis is arbitrary if they are opposite.
Quat turn_between(const Vec3& from, const Vec3& to);

/// The rotation about +Y that takes +Z to the heading of `direction` (its horizontal part).
/// Identity when the horizontal part vanishes.
Quat heading(const Vec3& direction);

/// The twist of `rotation` about the unit vector `axis` (swing–twist decomposition).
Quat twist_about(const Quat& rotation, const Vec3& axis);

/// The rotation whose matrix columns are x, y, z after Gram–Schmidt: x exact in direction, y as
/// near to `y_hint` as orthogonality allows. `x` and `y_hint` must not be parallel.
Quat frame_from(const Vec3& x, const Vec3& y_hint);

enum class Axis { x, y, z };

/// The Euler angles (radians) about the three different axes `order[0]`, `order[1]`, `order[2]`,
/// such that rotation = R₀·R₁·R₂ on column vectors, the convention of BVH's CHANNELS. The middle
/// angle lies in [−π/2, π/2]. At gimbal lock the third angle is 0.
Vec3 to_euler(const std::array<Axis, 3>& order, const Quat& rotation);

/// A rotation as two direction vectors, d1 = R·e1 and d2 = R·e2 (the six numbers of the emotion
/// thesis; the 6D form of Zhou et al. 2019). Their lengths carry no meaning.
struct DirectionVectors {
  Vec3 d1;
  Vec3 d2;
};

DirectionVectors to_direction_vectors(const Quat& rotation);

/// The rotation of two direction vectors: x = d1/|d1|, z = (x×d2)/|x×d2|, y = z×x. When |d1| < 0.05
/// or |x×d2| < 0.05·|d2| the directions are degenerate, and `previous` supplies the missing
/// direction.
Quat to_rotation(const DirectionVectors& directions, const Quat& previous);

}  // namespace mien::motion
