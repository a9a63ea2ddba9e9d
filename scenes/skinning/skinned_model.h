#pragma once

#include <array>
#include <vector>

#include "motion/math/geometry.h"
#include "motion/skeleton/pose.h"
#include "render/scene/scene.h"

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

inline constexpr int most_influences = 8;

/// How much one joint moves a vertex.
struct Influence {
  int joint = 0;
  float weight = 0.0f;
};

/// A surface that follows joints. As it was modelled (bind pose); world space, metres.
struct SkinnedMesh {
  std::vector<motion::Vec3> positions;
  std::vector<motion::Vec3> normals;               ///< unit, one a vertex
  std::vector<std::array<float, 2>> uv;            ///< one a vertex, or empty
  std::vector<std::array<int, 3>> triangles;       ///< counter-clockwise seen from outside
  std::vector<int> triangle_parts;                 ///< one a triangle (a joint's index), or empty
  std::vector<std::vector<Influence>> influences;  ///< 1 … 8 a vertex; weights sum to 1
  int material = 0;                                ///< index into the model's own list of materials
};

/// Where each joint has gone from the bind pose: the world transform of now times the inverse of
/// that of the bind pose.
using JointMotions = std::vector<Eigen::Affine3d>;

/// From rigid joints: `now` and `bind` are of the same skeleton.
JointMotions joint_motions(const motion::JointTransforms& bind, const motion::JointTransforms& now);

/// Linear blend skinning: every vertex goes by the weighted mean of its joints' matrices, its
/// normal by the cofactors of that matrix. Any affine motions. Limbs that twist grow thin.
render::Mesh skinned_linearly(const SkinnedMesh& mesh, const JointMotions& motions);

/// Dual quaternion skinning (Kavan et al. 2008): every vertex goes by the normalised weighted sum
/// of its joints' dual quaternions, each taken in the hemisphere of that with the largest weight.
/// Rigid motions only. Limbs that twist keep their volume.
render::Mesh skinned_rigidly(const SkinnedMesh& mesh, const JointMotions& motions);

/// Makes weights sum to 1 and keeps the eight largest, larger ones first. Negative ones and those
/// below a thousandth of the largest go. There must be a positive one.
void normalize(std::vector<Influence>& influences);

/// Throws std::invalid_argument, naming the member, when lists do not match, an index is out of
/// range for so many joints, weights do not sum to 1 or a number is not finite.
void validate(const SkinnedMesh& mesh, int joint_count);

}  // namespace mien::scenes
