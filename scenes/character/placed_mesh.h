#pragma once

#include <cstddef>
#include <vector>

#include "scenes/character/bind_pose.h"
#include "scenes/skinning/skinned_model.h"

namespace mien::scenes {

/// The most vertices of all meshes of a character.
inline constexpr std::size_t most_vertices = 4'000'000;

/// Moves a mesh from its own space into the bind pose, by the same blend as skinning. Influences,
/// which refer to joints of the skin beforehand, refer to joints of the rig afterwards.
/// `skin_joints` are the nodes of the skin's joints and `to_world` their transforms (mesh space →
/// bind pose). If these mirror the mesh, its triangles are turned over. Morph targets are moved
/// with the mesh.
void place_mesh(const BindPoseRig& rig, const std::vector<int>& skin_joints,
                const std::vector<Eigen::Affine3d>& to_world, SkinnedMesh& mesh);

/// Makes normals unit; without any, they are the area-weighted means of the triangles' normals.
/// Gives morph targets the normals that they lack (complete_morph_normals).
void complete_normals(SkinnedMesh& mesh);

}  // namespace mien::scenes
