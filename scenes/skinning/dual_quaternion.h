#pragma once

#include "motion/math/geometry.h"

namespace mien::scenes {

/// A rigid motion as a dual quaternion, real + ε·dual (Kavan, Collins, Žára and O'Sullivan 2008).
///
/// Unit: |real| = 1 and real · dual = 0. Sums of weighted unit dual quaternions become unit again
/// by `normalized`.
struct DualQuaternion {
  Eigen::Vector4d real{0.0, 0.0, 0.0, 1.0};  ///< x, y, z, w
  Eigen::Vector4d dual = Eigen::Vector4d::Zero();
};

/// Turns by the unit quaternion `rotation`, then moves by `translation`.
DualQuaternion dual_quaternion(const motion::Quat& rotation, const motion::Vec3& translation);

/// The unit dual quaternion nearest in direction; `real` must not be zero.
DualQuaternion normalized(const DualQuaternion& sum);

/// Of a unit dual quaternion.
motion::Quat rotation_of(const DualQuaternion& rigid);
motion::Vec3 translation_of(const DualQuaternion& rigid);

}  // namespace mien::scenes
