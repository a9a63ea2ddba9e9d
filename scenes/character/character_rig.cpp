#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include "motion/formats/gltf/gltf_accessor.h"
#include "motion/math/rotation.h"
#include "scenes/character/character_file.h"

namespace mien::scenes {

namespace {

using motion::Vec3;
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

/// The nodes as they are posed in the file, world space.
std::vector<Eigen::Affine3d> at_rest(const CharacterFile& file) {
  std::vector<Eigen::Affine3d> world(static_cast<size_t>(file.nodes.size()));
  for (const int node : file.nodes.parents_first) {
    const motion::NodeTransform& local = file.nodes.at_rest[static_cast<size_t>(node)];
    Eigen::Affine3d transform = Eigen::Affine3d::Identity();
    transform.translate(local.translation).rotate(local.rotation).scale(local.scale);
    const int parent = file.nodes.parents[static_cast<size_t>(node)];
    world[static_cast<size_t>(node)] =
        parent < 0 ? transform : world[static_cast<size_t>(parent)] * transform;
  }
  return world;
}

Eigen::Affine3d local_of(const CharacterFile& file, int node) {
  const motion::NodeTransform& local = file.nodes.at_rest[static_cast<size_t>(node)];
  Eigen::Affine3d transform = Eigen::Affine3d::Identity();
  return transform.translate(local.translation).rotate(local.rotation).scale(local.scale);
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
    if (!(std::abs(inverses[j].linear().determinant()) > 1e-24)) {
      motion::refuse(file.gltf, use + ": one flattens the mesh", get_it_again);
    }
  }
  return inverses;
}

/// A linear part as a rotation, or a mirror image, of no scale.
struct Attitude {
  Eigen::Matrix3d turn;
  bool is_square = false;  ///< it goes along the axes, and exactly so whatever the file rounds
};

Attitude attitude_of(const Eigen::Matrix3d& linear) {
  const Eigen::Matrix3d turn = linear / std::cbrt(std::abs(linear.determinant()));
  const Eigen::Matrix3d whole = turn.array().round();
  const bool is_square = (turn - whole).cwiseAbs().maxCoeff() < 1e-3;
  return {is_square ? whole : turn, is_square};
}

/// Works out the bind pose, skin after skin. It is the same however the file poses its nodes: of
/// these only the attitude of the whole is taken, and what holds skins together that share no
/// joint.
struct Binder {
  const CharacterFile& file;
  std::vector<Eigen::Affine3d> rest;
  std::map<int, Eigen::Affine3d> bind;  ///< by node
  std::vector<std::vector<Eigen::Affine3d>> skin_to_world;
  std::optional<Eigen::Affine3d> settling;  ///< world of the file → that of the bind pose

  /// Mesh space → the file's world by the joint with which most others agree: all do where the
  /// nodes stand in the bind pose. Figures are modelled along the axes, so that of a posed one the
  /// joints go before that say so.
  Eigen::Affine3d posed_place(int skin, const std::vector<Eigen::Affine3d>& inverses) const {
    constexpr size_t most_compared = 128;
    const std::vector<int>& joints = joints_of(file, skin);
    const size_t count = std::min(most_compared, joints.size());
    const auto place_by = [&](size_t j) {
      return Eigen::Affine3d(rest[static_cast<size_t>(joints[j])] * inverses[j]);
    };
    Eigen::Affine3d best = place_by(0);
    std::pair<bool, size_t> most = {false, 0};
    for (size_t j = 0; j < count && most.second < count; ++j) {
      const Eigen::Affine3d place = place_by(j);
      const double tolerance = 1e-3 * place.matrix().cwiseAbs().maxCoeff();
      size_t agreeing = 0;
      for (size_t k = 0; k < count; ++k) {
        const Eigen::Matrix4d apart = place_by(k).matrix() - place.matrix();
        agreeing += apart.cwiseAbs().maxCoeff() < tolerance ? 1 : 0;
      }
      const std::pair<bool, size_t> support = {attitude_of(place.linear()).is_square, agreeing};
      if (support <= most) continue;
      most = support;
      best = place;
    }
    return best;
  }

  /// What places the mesh space of a skin in the bind pose: a joint that another skin has bound,
  /// else the nodes.
  Eigen::Affine3d placing(int skin, const std::vector<Eigen::Affine3d>& inverses) {
    const std::vector<int>& joints = joints_of(file, skin);
    for (size_t j = 0; j < joints.size(); ++j) {
      const auto known = bind.find(joints[j]);
      if (known != bind.end()) return known->second * inverses[j];
    }
    const Eigen::Affine3d posed = posed_place(skin, inverses);
    if (settling) return *settling * posed;
    Eigen::Affine3d place = Eigen::Affine3d::Identity();
    place.linear() = attitude_of(posed.linear()).turn;
    settling = place * posed.inverse();
    return place;
  }

  void add(int skin) {
    std::vector<Eigen::Affine3d>& to_world = skin_to_world[static_cast<size_t>(skin)];
    if (!to_world.empty()) return;
    const std::vector<Eigen::Affine3d> inverses = inverse_binds(file, skin);
    const Eigen::Affine3d place = placing(skin, inverses);
    const std::vector<int>& joints = joints_of(file, skin);
    for (size_t j = 0; j < joints.size(); ++j) {
      // A joint that several skins share keeps the bind pose that it got first.
      const auto [joint, is_new] = bind.try_emplace(joints[j], place * inverses[j].inverse());
      to_world.push_back(joint->second * inverses[j]);
    }
  }

  /// The children that a skin binds: where they are on the node, and where in the bind pose.
  struct Children {
    std::vector<Vec3> on_node;
    std::vector<Vec3> bound;
  };

  Children bound_children(int node) const {
    Children found;
    for (const int child : file.nodes.children[static_cast<size_t>(node)]) {
      const auto known = bind.find(child);
      if (known == bind.end()) continue;
      found.on_node.push_back(file.nodes.at_rest[static_cast<size_t>(child)].translation);
      found.bound.emplace_back(known->second.translation());
    }
    return found;
  }

  /// A root that no skin binds: where its children say, when there are enough of them.
  Eigen::Affine3d unbound_root(int node) const {
    const Children children = bound_children(node);
    const auto count = static_cast<Eigen::Index>(children.bound.size());
    const Eigen::Affine3d posed =
        settling.value_or(Eigen::Affine3d::Identity()) * rest[static_cast<size_t>(node)];
    if (count < 3) return posed;
    Eigen::Matrix3Xd from(3, count);
    Eigen::Matrix3Xd to(3, count);
    for (Eigen::Index i = 0; i < count; ++i) {
      from.col(i) = children.on_node[static_cast<size_t>(i)];
      to.col(i) = children.bound[static_cast<size_t>(i)];
    }
    const Eigen::Matrix3Xd spread = from.colwise() - from.rowwise().mean();
    if (spread.jacobiSvd().rank() < 2) return posed;
    return Eigen::Affine3d(Eigen::umeyama(from, to, true));
  }

  /// A joint that no skin binds, on one that has its bind pose: turned so that its first bound
  /// child is where it is.
  Eigen::Affine3d unbound_joint(int node, const Eigen::Affine3d& parent) const {
    const Eigen::Affine3d posed = parent * local_of(file, node);
    const Children children = bound_children(node);
    if (children.bound.empty()) return posed;
    const Vec3 place = posed.translation();
    const Vec3 wanted = children.bound.front() - place;
    const Vec3 seen = posed * children.on_node.front() - place;
    if (!(wanted.norm() > 0.0 && seen.norm() > 0.0)) return posed;
    return Eigen::Translation3d(place) * motion::turn_between(seen, wanted) *
           Eigen::Translation3d(-place) * posed;
  }
};

/// Whether a skin's mesh is the mirror image of what was modelled.
bool rig_is_mirrored(const Binder& binder) {
  for (const auto& to_world : binder.skin_to_world) {
    if (!to_world.empty()) return to_world.front().linear().determinant() < 0.0;
  }
  return false;
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

/// The nearest joint at or above a node; −1 when there is none.
int joint_above(const CharacterFile& file, const std::vector<int>& joint_of_node, int node) {
  while (node >= 0 && joint_of_node[static_cast<size_t>(node)] < 0) {
    node = file.nodes.parents[static_cast<size_t>(node)];
  }
  return node < 0 ? -1 : joint_of_node[static_cast<size_t>(node)];
}

/// VRM's name for each node that is a bone of its humanoid (VRM 1: VRMC_vrm, VRM 0: VRM).
std::map<int, std::string> humanoid_bones(const CharacterFile& file) {
  std::map<int, std::string> bones;
  const auto extensions = file.json.find("extensions");
  if (extensions == file.json.end()) return bones;
  const auto humanoid = [&](const char* extension) -> json {
    const json vrm = extensions->is_object() ? extensions->value(extension, json()) : json();
    const json human = vrm.is_object() ? vrm.value("humanoid", json()) : json();
    return human.is_object() ? human.value("humanBones", json()) : json();
  };
  const size_t count = static_cast<size_t>(file.nodes.size());
  const json newer = humanoid("VRMC_vrm");
  if (newer.is_object()) {
    for (const auto& [name, bone] : newer.items()) {
      bones[index_in(file, bone, "node", count, "humanoid bone " + name)] = name;
    }
  }
  for (const json& bone : humanoid("VRM")) {
    if (!bone.is_object() || !bone.contains("bone") || !bone["bone"].is_string()) continue;
    const auto name = bone["bone"].get<std::string>();
    bones[index_in(file, bone, "node", count, "humanoid bone " + name)] = name;
  }
  bones.erase(-1);
  return bones;
}

/// The joints with their names and places.
motion::Skeleton skeleton_of(const CharacterFile& file, const BindPoseRig& rig) {
  const std::map<int, std::string> humanoid = humanoid_bones(file);
  motion::Skeleton skeleton;
  for (size_t j = 0; j < rig.nodes.size(); ++j) {
    const int node = rig.nodes[j];
    motion::Joint joint;
    joint.name = file.gltf.model.nodes[static_cast<size_t>(node)].name;
    const auto bone = humanoid.find(node);
    // Where VRM says which nodes are bones, other nodes' names shall say nothing.
    if (bone != humanoid.end()) joint.name = bone->second;
    const bool says_nothing = !humanoid.empty() && bone == humanoid.end();
    if (joint.name.empty() || says_nothing) joint.name = "joint_" + std::to_string(j);
    const int parent = file.nodes.parents[static_cast<size_t>(node)];
    if (j > 0) joint.parent = rig.joint_of_node[static_cast<size_t>(parent)];
    const Vec3 from = j > 0 ? Vec3(rig.bind[static_cast<size_t>(joint.parent)].translation())
                            : Vec3(Vec3::Zero());
    joint.offset = rig.bind[j].translation() - from;
    if (!joint.offset.allFinite() || joint.offset.norm() > 1e9) {
      motion::refuse(file.gltf, "a joint is too far away", "check the scales of the nodes");
    }
    skeleton.joints.push_back(std::move(joint));
  }
  return skeleton;
}

/// Hangs meshes without a skin on the joint above them, as they are posed in the file.
void hang_meshes(const CharacterFile& file, const std::vector<Eigen::Affine3d>& rest,
                 BindPoseRig& rig) {
  for (PlacedMesh& mesh : rig.meshes) {
    if (mesh.skin >= 0) continue;
    mesh.joint = joint_above(file, rig.joint_of_node, mesh.node);
    if (mesh.joint < 0) continue;
    const auto node = static_cast<size_t>(rig.nodes[static_cast<size_t>(mesh.joint)]);
    mesh.to_world = rig.bind[static_cast<size_t>(mesh.joint)] * rest[node].inverse() *
                    rest[static_cast<size_t>(mesh.node)];
  }
}

/// Leaves out meshes that nothing would move.
void drop_loose_meshes(BindPoseRig& rig, std::vector<std::string>& warnings) {
  const size_t before = rig.meshes.size();
  std::erase_if(rig.meshes, [](const PlacedMesh& mesh) { return mesh.skin < 0 && mesh.joint < 0; });
  if (rig.meshes.size() == before) return;
  warnings.push_back(std::to_string(before - rig.meshes.size()) +
                     " mesh(es) hang on no joint and are not drawn.");
}

}  // namespace

BindPoseRig bind_pose_rig(const CharacterFile& file, std::vector<std::string>& warnings) {
  BindPoseRig rig;
  rig.meshes = placed_meshes(file);
  if (file.gltf.model.skins.empty()) motion::refuse(file.gltf, "holds no skin", with_armature);
  Binder binder{file, at_rest(file), {}, {}, std::nullopt};
  binder.skin_to_world.resize(file.gltf.model.skins.size());
  for (const PlacedMesh& mesh : rig.meshes) {
    if (mesh.skin < 0) continue;
    check_skin(file, mesh.skin);
    binder.add(mesh.skin);
  }
  const std::vector<int> wanted = wanted_nodes(file, rig.meshes);
  if (wanted.empty()) motion::refuse(file.gltf, "no mesh follows a skin", with_armature);
  rig.nodes =
      motion::nodes_between(file.nodes, motion::common_root(file.gltf, file.nodes, wanted), wanted);
  rig.joint_of_node.assign(static_cast<size_t>(file.nodes.size()), -1);
  for (size_t j = 0; j < rig.nodes.size(); ++j) {
    const int node = rig.nodes[j];
    const int parent = file.nodes.parents[static_cast<size_t>(node)];
    const auto bound = binder.bind.find(node);
    if (bound != binder.bind.end()) {
      rig.bind.push_back(bound->second);
    } else if (j == 0) {
      rig.bind.push_back(binder.unbound_root(node));
    } else {
      const int above = rig.joint_of_node[static_cast<size_t>(parent)];
      rig.bind.push_back(binder.unbound_joint(node, rig.bind[static_cast<size_t>(above)]));
    }
    rig.joint_of_node[static_cast<size_t>(node)] = static_cast<int>(j);
  }
  hang_meshes(file, binder.rest, rig);
  drop_loose_meshes(rig, warnings);
  rig.skeleton = skeleton_of(file, rig);
  rig.is_mirrored = rig_is_mirrored(binder);
  rig.skin_to_world = std::move(binder.skin_to_world);
  return rig;
}

}  // namespace mien::scenes
