#include "scenes/character/fbx_character.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "motion/error.h"
#include "motion/formats/fbx/fbx_figure.h"
#include "motion/formats/fbx/fbx_pose.h"
#include "motion/skeleton/recording.h"

namespace mien::scenes {

namespace {

constexpr std::string_view with_skeleton = "export the figure with its skeleton and skin weights";

/// The models at rest, in a world with +Y up.
PosedNodes posed_nodes(const motion::FbxScene& scene) {
  PosedNodes nodes;
  for (const motion::FbxPlace& place : motion::places_of(scene, motion::at_rest(scene))) {
    Eigen::Affine3d world = Eigen::Affine3d::Identity();
    world.linear() = scene.settings.to_y_up * place.linear;
    world.translation() = scene.settings.to_y_up * place.position;
    nodes.world.push_back(world);
  }
  for (size_t m = 0; m < scene.models.size(); ++m) {
    const int parent = scene.models[m].parent;
    nodes.parents.push_back(parent);
    nodes.children.push_back(scene.models[m].children);
    nodes.local.push_back(parent < 0 ? nodes.world[m]
                                     : nodes.world[static_cast<size_t>(parent)].inverse() *
                                           nodes.world[m]);
  }
  return nodes;
}

/// What the clusters of a mesh whose bones are joints bind. Others are removed from the mesh.
SkinBinding binding_of(const motion::FbxScene& scene, const std::vector<bool>& is_joint,
                       motion::FbxMesh& mesh) {
  std::erase_if(mesh.clusters, [&](const motion::FbxCluster& cluster) {
    return !is_joint[static_cast<size_t>(cluster.model)];
  });
  SkinBinding binding;
  for (const motion::FbxCluster& cluster : mesh.clusters) {
    const Eigen::Affine3d to_joint = cluster.to_bone * mesh.geometric;
    if (flattens(to_joint) || (cluster.bind && flattens(*cluster.bind))) {
      throw Error({scene.document.file}, "a bone of a skin flattens the mesh", motion::fbx_again);
    }
    binding.joints.push_back(cluster.model);
    binding.to_joint.push_back(to_joint);
    if (!cluster.bind || binding.to_world) continue;
    Eigen::Affine3d to_world = *cluster.bind * to_joint;
    binding.to_world = scene.settings.to_y_up * to_world;
  }
  return binding;
}

void drop_hidden(std::vector<motion::FbxMesh>& meshes, std::vector<std::string>& warnings) {
  const size_t hidden = std::erase_if(
      meshes, [](const motion::FbxMesh& mesh) { return !mesh.is_visible || mesh.corners.empty(); });
  if (hidden == 0) return;
  warnings.push_back(std::to_string(hidden) + " mesh(es) are hidden or empty and are not drawn.");
}

std::vector<bool> marked(size_t count, const std::vector<int>& chosen) {
  std::vector<bool> marks(count, false);
  for (const int one : chosen) marks[static_cast<size_t>(one)] = true;
  return marks;
}

}  // namespace

FbxCharacter parse_fbx_character(std::string_view bytes, const std::string& name,
                                 std::vector<std::string>& warnings) {
  FbxCharacter character;
  character.scene = motion::parse_fbx_scene(bytes, name);
  const motion::FbxScene& scene = character.scene;
  const std::vector<bool> none_moves(scene.models.size(), false);
  motion::Recording noted;
  const motion::FbxFigure figure =
      motion::fbx_figure(scene, motion::fbx_joints(scene, none_moves), std::nullopt, noted);
  warnings.insert(warnings.end(), noted.notes.begin(), noted.notes.end());
  RigNodes rig{figure.joints, {}};
  for (const motion::Joint& joint : motion::fbx_skeleton(scene, figure, none_moves).joints) {
    rig.names.push_back(joint.name);
  }
  character.meshes = motion::fbx_meshes(scene);
  drop_hidden(character.meshes, warnings);
  const std::vector<bool> is_joint = marked(scene.models.size(), figure.joints);
  std::vector<SkinBinding> skins;
  std::vector<PlacedMesh> placed;
  bool has_skin = false;
  for (motion::FbxMesh& mesh : character.meshes) {
    const int index = static_cast<int>(placed.size());
    skins.push_back(binding_of(scene, is_joint, mesh));
    const bool is_skinned = !skins.back().joints.empty();
    placed.push_back({mesh.model, index, is_skinned ? index : -1});
    has_skin |= is_skinned;
  }
  if (!has_skin) throw Error({name}, "no mesh follows a skin of its skeleton", with_skeleton);
  character.rig = bind_pose_rig(posed_nodes(scene), skins, std::move(placed), rig, name, warnings);
  for (PlacedMesh& mesh : character.rig.meshes) {
    if (mesh.skin < 0)
      mesh.to_world = mesh.to_world * character.meshes[static_cast<size_t>(mesh.mesh)].geometric;
  }
  return character;
}

CharacterParts fbx_parts(std::string_view bytes, const std::string& name,
                         const std::optional<std::filesystem::path>& folder) {
  CharacterParts parts;
  parts.file = name;
  FbxCharacter character = parse_fbx_character(bytes, name, parts.warnings);
  FbxPaint paint = fbx_paint(character, folder, parts.warnings);
  parts.meshes = fbx_skinned_meshes(character, paint, parts.warnings);
  parts.paint = std::move(paint.paint);
  parts.is_mirrored = character.rig.is_mirrored;
  parts.rig = std::move(character.rig.skeleton);
  return parts;
}

}  // namespace mien::scenes
