#include "scenes/character/bind_pose.h"

#include <algorithm>
#include <map>
#include <utility>

#include <Eigen/SVD>

#include "motion/error.h"
#include "motion/math/rotation.h"

namespace mien::scenes {

namespace {

using motion::Vec3;

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
  const PosedNodes& nodes;
  const std::vector<SkinBinding>& skins;
  std::map<int, Eigen::Affine3d> bind;  ///< by node
  std::vector<std::vector<Eigen::Affine3d>> skin_to_world;
  std::optional<Eigen::Affine3d> settling;  ///< world of the file → that of the bind pose

  /// Mesh space → the file's world by the joint with which most others agree: all do where the
  /// nodes stand in the bind pose. Figures are modelled along the axes, so that of a posed one the
  /// joints go before that say so.
  Eigen::Affine3d posed_place(const SkinBinding& skin) const {
    constexpr size_t most_compared = 128;
    const std::vector<int>& joints = skin.joints;
    const size_t count = std::min(most_compared, joints.size());
    const auto place_by = [&](size_t j) {
      return Eigen::Affine3d(nodes.world[static_cast<size_t>(joints[j])] * skin.to_joint[j]);
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
  /// else what the file states, else the nodes.
  Eigen::Affine3d placing(const SkinBinding& skin) {
    for (size_t j = 0; j < skin.joints.size(); ++j) {
      const auto known = bind.find(skin.joints[j]);
      if (known != bind.end()) return known->second * skin.to_joint[j];
    }
    const Eigen::Affine3d posed = posed_place(skin);
    if (settling && !skin.to_world) return *settling * posed;
    Eigen::Affine3d place = Eigen::Affine3d::Identity();
    place.linear() = attitude_of(posed.linear()).turn;
    if (skin.to_world) place = *skin.to_world;
    if (settling) return place;
    settling = place * posed.inverse();
    return place;
  }

  void add(int skin) {
    std::vector<Eigen::Affine3d>& to_world = skin_to_world[static_cast<size_t>(skin)];
    if (!to_world.empty()) return;
    const SkinBinding& binding = skins[static_cast<size_t>(skin)];
    const Eigen::Affine3d place = placing(binding);
    for (size_t j = 0; j < binding.joints.size(); ++j) {
      const Eigen::Affine3d& to_joint = binding.to_joint[j];
      // A joint that several skins share keeps the bind pose that it got first.
      const auto [joint, is_new] = bind.try_emplace(binding.joints[j], place * to_joint.inverse());
      to_world.push_back(joint->second * to_joint);
    }
  }

  /// The children that a skin binds: where they are on the node, and where in the bind pose.
  struct Children {
    std::vector<Vec3> on_node;
    std::vector<Vec3> bound;
  };

  Children bound_children(int node) const {
    Children found;
    for (const int child : nodes.children[static_cast<size_t>(node)]) {
      const auto known = bind.find(child);
      if (known == bind.end()) continue;
      found.on_node.emplace_back(nodes.local[static_cast<size_t>(child)].translation());
      found.bound.emplace_back(known->second.translation());
    }
    return found;
  }

  /// A root that no skin binds: where its children say, when there are enough of them.
  Eigen::Affine3d unbound_root(int node) const {
    const Children children = bound_children(node);
    const auto count = static_cast<Eigen::Index>(children.bound.size());
    const Eigen::Affine3d posed =
        settling.value_or(Eigen::Affine3d::Identity()) * nodes.world[static_cast<size_t>(node)];
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
    const Eigen::Affine3d posed = parent * nodes.local[static_cast<size_t>(node)];
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

/// The nearest joint at or above a node; −1 when there is none.
int joint_above(const PosedNodes& nodes, const std::vector<int>& joint_of_node, int node) {
  while (node >= 0 && joint_of_node[static_cast<size_t>(node)] < 0) {
    node = nodes.parents[static_cast<size_t>(node)];
  }
  return node < 0 ? -1 : joint_of_node[static_cast<size_t>(node)];
}

/// Hangs meshes without a skin on the joint above them, as they are posed in the file.
void hang_meshes(const PosedNodes& nodes, BindPoseRig& rig) {
  for (PlacedMesh& mesh : rig.meshes) {
    if (mesh.skin >= 0) continue;
    mesh.joint = joint_above(nodes, rig.joint_of_node, mesh.node);
    if (mesh.joint < 0) continue;
    const auto node = static_cast<size_t>(rig.nodes[static_cast<size_t>(mesh.joint)]);
    mesh.to_world = rig.bind[static_cast<size_t>(mesh.joint)] * nodes.world[node].inverse() *
                    nodes.world[static_cast<size_t>(mesh.node)];
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

/// The joints with their names and places.
motion::Skeleton skeleton_of(const PosedNodes& nodes, const RigNodes& named, const BindPoseRig& rig,
                             const std::string& file) {
  motion::Skeleton skeleton;
  for (size_t j = 0; j < rig.nodes.size(); ++j) {
    motion::Joint joint;
    joint.name = named.names[j];
    const int parent = nodes.parents[static_cast<size_t>(rig.nodes[j])];
    if (j > 0) joint.parent = rig.joint_of_node[static_cast<size_t>(parent)];
    const Vec3 from = j > 0 ? Vec3(rig.bind[static_cast<size_t>(joint.parent)].translation())
                            : Vec3(Vec3::Zero());
    joint.offset = rig.bind[j].translation() - from;
    if (!joint.offset.allFinite() || joint.offset.norm() > 1e9) {
      throw Error({file}, "a joint is too far away", "check the scales of the nodes");
    }
    skeleton.joints.push_back(std::move(joint));
  }
  return skeleton;
}

/// The bind pose of each joint, parents before children.
void add_joints(const PosedNodes& nodes, const RigNodes& named, const Binder& binder,
                BindPoseRig& rig) {
  rig.nodes = named.nodes;
  rig.joint_of_node.assign(nodes.parents.size(), -1);
  for (size_t j = 0; j < rig.nodes.size(); ++j) {
    const int node = rig.nodes[j];
    const int parent = nodes.parents[static_cast<size_t>(node)];
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
}

}  // namespace

BindPoseRig bind_pose_rig(const PosedNodes& nodes, const std::vector<SkinBinding>& skins,
                          std::vector<PlacedMesh> meshes, const RigNodes& named,
                          const std::string& file, std::vector<std::string>& warnings) {
  BindPoseRig rig;
  rig.meshes = std::move(meshes);
  Binder binder{nodes, skins, {}, {}, std::nullopt};
  binder.skin_to_world.resize(skins.size());
  for (const PlacedMesh& mesh : rig.meshes) {
    if (mesh.skin >= 0) binder.add(mesh.skin);
  }
  add_joints(nodes, named, binder, rig);
  hang_meshes(nodes, rig);
  drop_loose_meshes(rig, warnings);
  rig.skeleton = skeleton_of(nodes, named, rig, file);
  rig.is_mirrored = rig_is_mirrored(binder);
  rig.skin_to_world = std::move(binder.skin_to_world);
  return rig;
}

}  // namespace mien::scenes
