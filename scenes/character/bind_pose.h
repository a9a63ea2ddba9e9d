#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "motion/skeleton/skeleton.h"

namespace mien::scenes {

/// The nodes of a file as it poses them, whatever its format.
struct PosedNodes {
  std::vector<int> parents;  ///< −1 for roots
  std::vector<std::vector<int>> children;
  std::vector<Eigen::Affine3d> local;  ///< node → its parent
  std::vector<Eigen::Affine3d> world;  ///< node → the file's world
};

/// What binds a mesh to joints.
struct SkinBinding {
  std::vector<int> joints;                ///< nodes; at least one
  std::vector<Eigen::Affine3d> to_joint;  ///< mesh space → each joint's own, in the bind pose
  /// Mesh space → the file's world in the bind pose, if the file states it.
  std::optional<Eigen::Affine3d> to_world;
};

/// An instance of a mesh in the file.
struct PlacedMesh {
  int node = -1;
  int mesh = -1;
  int skin = -1;   ///< skin that deforms it; −1: it is attached to a joint
  int joint = -1;  ///< joint of the rig that a mesh without a skin is attached to
  /// For an attached mesh: mesh space → bind pose.
  Eigen::Affine3d to_world = Eigen::Affine3d::Identity();
};

/// The joints of all skins in use and the nodes between them, in their bind pose.
struct BindPoseRig {
  std::vector<PlacedMesh> meshes;
  std::vector<int> nodes;             ///< node of each joint of `skeleton`
  std::vector<int> joint_of_node;     ///< −1 for nodes that are not joints
  motion::Skeleton skeleton;          ///< bind pose, frames parallel to the file's world
  std::vector<Eigen::Affine3d> bind;  ///< world transform of each joint
  bool is_mirrored = false;  ///< whether the meshes are stored as the figure's mirror image

  /// For each skin and each of its joints: mesh space → world in the bind pose; empty for skins
  /// that are not in use.
  std::vector<std::vector<Eigen::Affine3d>> skin_to_world;
};

/// The nodes of a rig with the names of its joints.
struct RigNodes {
  std::vector<int> nodes;          ///< parents before children; the first is the root of all others
  std::vector<std::string> names;  ///< of each
};

/// The bind pose of `rig` from the skins of `meshes`. It is the same however the file poses its
/// nodes: of these only the orientation of the whole is used, the positions of skins that share no
/// joint, of joints in no skin and of meshes without a skin. Meshes without a skin are attached to
/// the joint above them; those that nothing would move are omitted with a warning.
///
/// Throws mien::Error, naming the file, if a joint is too far away.
BindPoseRig bind_pose_rig(const PosedNodes& nodes, const std::vector<SkinBinding>& skins,
                          std::vector<PlacedMesh> meshes, const RigNodes& rig,
                          const std::string& file, std::vector<std::string>& warnings);

/// Whether a matrix flattens what it transforms.
inline bool flattens(const Eigen::Affine3d& transform) {
  return !(std::abs(transform.linear().determinant()) > 1e-24);
}

}  // namespace mien::scenes
