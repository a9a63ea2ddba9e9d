#include <algorithm>
#include <set>
#include <utility>

#include "motion/formats/gltf/gltf_accessor.h"
#include "scenes/character/character_file.h"

namespace mien::scenes {

namespace {

using nlohmann::json;

using motion::get_it_again;
constexpr std::string_view with_armature = "export the figure with its armature and skin weights";

/// Every mesh that a node places. Meshes of nodes without a skin are kept for later judgement.
std::vector<PlacedMesh> placed_meshes(const CharacterFile& file) {
  std::vector<PlacedMesh> placed;
  const json& nodes = list_in(file.json, "nodes");
  const size_t mesh_count = list_in(file.json, "meshes").size();
  const size_t skin_count = file.gltf.model.skins.size();
  for (size_t n = 0; n < nodes.size(); ++n) {
    const std::string use = "node " + std::to_string(n);
    PlacedMesh mesh{static_cast<int>(n), index_in(file, nodes[n], "mesh", mesh_count, use),
                    index_in(file, nodes[n], "skin", skin_count, use)};
    if (mesh.mesh >= 0) placed.push_back(mesh);
  }
  return placed;
}

const std::vector<int>& joints_of(const CharacterFile& file, int skin) {
  return file.gltf.model.skins[static_cast<size_t>(skin)].joints;
}

void check_skin(const CharacterFile& file, int skin) {
  const std::string use = "skin " + std::to_string(skin);
  const std::vector<int>& joints = joints_of(file, skin);
  if (joints.empty()) motion::refuse(file.gltf, use + " has no joints", with_armature);
  for (const int joint : joints) {
    if (joint >= 0 && joint < file.nodes.size()) continue;
    motion::refuse(file.gltf, use + " has a joint that does not exist", get_it_again);
  }
}

/// The nodes as they are posed in the file.
PosedNodes posed_nodes(const CharacterFile& file) {
  PosedNodes nodes{file.nodes.parents, file.nodes.children, {}, {}};
  for (const motion::NodeTransform& local : file.nodes.at_rest) {
    Eigen::Affine3d transform = Eigen::Affine3d::Identity();
    nodes.local.push_back(
        transform.translate(local.translation).rotate(local.rotation).scale(local.scale));
  }
  nodes.world.resize(nodes.local.size());
  for (const int node : file.nodes.parents_first) {
    const int parent = nodes.parents[static_cast<size_t>(node)];
    const Eigen::Affine3d& local = nodes.local[static_cast<size_t>(node)];
    nodes.world[static_cast<size_t>(node)] =
        parent < 0 ? local : nodes.world[static_cast<size_t>(parent)] * local;
  }
  return nodes;
}

/// Mesh space → each joint's own, in the bind pose.
std::vector<Eigen::Affine3d> inverse_binds(const CharacterFile& file, int skin) {
  const tinygltf::Skin& given = file.gltf.model.skins[static_cast<size_t>(skin)];
  std::vector<Eigen::Affine3d> inverses(given.joints.size(), Eigen::Affine3d::Identity());
  if (given.inverseBindMatrices < 0) return inverses;
  const std::string use = "skin " + std::to_string(skin) + ", inverse bind matrices";
  const std::vector<double> numbers =
      motion::accessor_numbers(file.gltf, given.inverseBindMatrices, 16, use);
  if (numbers.size() < 16 * inverses.size()) {
    motion::refuse(file.gltf, use + ": there are fewer than joints", get_it_again);
  }
  for (size_t j = 0; j < inverses.size(); ++j) {
    const Eigen::Map<const Eigen::Matrix4d> matrix(numbers.data() + 16 * j);
    inverses[j].matrix() = matrix;
    inverses[j].makeAffine();
    if (flattens(inverses[j])) {
      motion::refuse(file.gltf, use + ": one flattens the mesh", get_it_again);
    }
  }
  return inverses;
}

std::vector<int> wanted_nodes(const CharacterFile& file, const std::vector<PlacedMesh>& meshes) {
  std::set<int> wanted;
  for (const PlacedMesh& mesh : meshes) {
    if (mesh.skin < 0) continue;
    const std::vector<int>& joints = joints_of(file, mesh.skin);
    wanted.insert(joints.begin(), joints.end());
  }
  return {wanted.begin(), wanted.end()};
}

/// The nodes with their names. Where VRM says which nodes are bones, which are named as in VRM
/// then, the names of other nodes say nothing.
RigNodes named_nodes(const CharacterFile& file, std::vector<int> nodes) {
  const std::vector<int>& bones = file.gltf.human_nodes;
  RigNodes rig{std::move(nodes), {}};
  for (size_t j = 0; j < rig.nodes.size(); ++j) {
    const int node = rig.nodes[j];
    std::string name = file.gltf.model.nodes[static_cast<size_t>(node)].name;
    const bool says_nothing = !bones.empty() && std::ranges::find(bones, node) == bones.end();
    if (name.empty() || says_nothing) name = "joint_" + std::to_string(j);
    rig.names.push_back(std::move(name));
  }
  return rig;
}

}  // namespace

BindPoseRig gltf_rig(const CharacterFile& file, std::vector<std::string>& warnings) {
  std::vector<PlacedMesh> meshes = placed_meshes(file);
  const size_t skin_count = file.gltf.model.skins.size();
  if (skin_count == 0) motion::refuse(file.gltf, "holds no skin", with_armature);
  std::vector<SkinBinding> skins(skin_count);
  for (const PlacedMesh& mesh : meshes) {
    if (mesh.skin < 0 || !skins[static_cast<size_t>(mesh.skin)].joints.empty()) continue;
    check_skin(file, mesh.skin);
    skins[static_cast<size_t>(mesh.skin)] = {joints_of(file, mesh.skin),
                                             inverse_binds(file, mesh.skin), std::nullopt};
  }
  const std::vector<int> wanted = wanted_nodes(file, meshes);
  if (wanted.empty()) motion::refuse(file.gltf, "no mesh follows a skin", with_armature);
  const int root = motion::common_root(file.gltf, file.nodes, wanted);
  return bind_pose_rig(posed_nodes(file), skins, std::move(meshes),
                       named_nodes(file, motion::nodes_between(file.nodes, root, wanted)),
                       file.gltf.name, warnings);
}

}  // namespace mien::scenes
