#pragma once

#include <array>
#include <span>
#include <vector>

#include "motion/math/geometry.h"
#include "motion/skeleton/pose.h"
#include "render/scene/scene.h"
#include "scenes/skinning/morph_target.h"

namespace mien::scenes {

/// A rigid motion as a dual quaternion, real + ε·dual (Kavan, Collins, Žára and O'Sullivan 2008).
///
/// Unit: |real| = 1 and real · dual = 0. `normalized` makes a weighted sum of unit dual quaternions
/// unit again.
struct DualQuaternion {
  Eigen::Vector4d real{0.0, 0.0, 0.0, 1.0};  ///< x, y, z, w
  Eigen::Vector4d dual = Eigen::Vector4d::Zero();
};

/// The dual quaternion that rotates by the unit quaternion `rotation`, then translates by
/// `translation`.
DualQuaternion dual_quaternion(const motion::Quat& rotation, const motion::Vec3& translation);

/// The sum scaled to a unit dual quaternion; its `real` part must not be zero.
DualQuaternion normalized(const DualQuaternion& sum);

/// Rotation and translation of a unit dual quaternion.
motion::Quat rotation_of(const DualQuaternion& rigid);
motion::Vec3 translation_of(const DualQuaternion& rigid);

inline constexpr int max_influences = 8;

/// The weight of one joint for a vertex.
struct Influence {
  int joint = 0;
  float weight = 0.0f;
};

/// A skinned mesh in its bind pose; world space, metres.
struct SkinnedMesh {
  std::vector<motion::Vec3> positions;
  std::vector<motion::Vec3> normals;          ///< unit, one per vertex
  std::vector<std::array<float, 2>> uv;       ///< one per vertex, or empty
  std::vector<std::array<int, 3>> triangles;  ///< counter-clockwise seen from outside
  std::vector<int> triangle_parts;            ///< one per triangle (a joint's index), or empty
  /// Influences of each vertex: 1 … 8, largest weight first; weights sum to 1.
  std::vector<std::vector<Influence>> influences;
  int material = 0;  ///< index into the model's own list of materials
  std::vector<MorphTarget> morphs;
};

/// Skinning matrices: each joint's present world transform times the inverse of its bind transform.
using JointMotions = std::vector<Eigen::Affine3d>;

/// The skinning matrices of rigid joints; `now` and `bind` are of the same skeleton.
JointMotions joint_motions(const motion::JointTransforms& bind, const motion::JointTransforms& now);

/// Linear blend skinning: every vertex is transformed by the weighted mean of its joints' matrices,
/// its normal by the cofactor matrix. Accepts any affine transforms. Twisting limbs lose volume.
render::Mesh linear_blend_skinned(const SkinnedMesh& mesh, const JointMotions& motions);

/// Linear blend skinning of a mesh that its morph targets have changed first; `weights` has one for
/// each morph of the figure.
render::Mesh morphed_and_skinned(const SkinnedMesh& mesh, const JointMotions& motions,
                                 std::span<const double> weights);

/// Dual quaternion skinning (Kavan et al. 2008): every vertex is transformed by the normalised
/// weighted sum of its joints' dual quaternions, each negated if its real part has a negative dot
/// product with that of the vertex's first joint. Rigid transforms only. Twisting limbs keep their
/// volume.
render::Mesh dual_quaternion_skinned(const SkinnedMesh& mesh, const JointMotions& motions);

/// Makes weights sum to 1 and keeps the eight largest, larger ones first. Negative ones and those
/// below a thousandth of the largest are removed. At least one weight must be positive.
void normalize(std::vector<Influence>& influences);

/// Orders the triangles so that those near each other in the list are near each other in space,
/// which makes them faster to trace (render::Mesh::triangles). Depends on the bind pose alone.
void cluster_triangles(SkinnedMesh& mesh);

/// Throws std::invalid_argument, naming the member, when lists do not match, an index is not below
/// `joint_count`, weights do not sum to 1, a normal is not of unit length or a number is not finite
/// or too large.
void validate(const SkinnedMesh& mesh, int joint_count);

}  // namespace mien::scenes
