#include "motion/formats/fbx/fbx_pose.h"

#include <algorithm>
#include <map>
#include <string>

#include "motion/error.h"

namespace mien::motion {

namespace {

/// How the world of the file becomes that of the recording. A left-handed file is mirrored in its
/// own z first, joints and all, and then turned.
struct WorldTurn {
  bool is_mirrored = false;
  Quat turn = Quat::Identity();
  double metres_per_unit = 1.0;

  Vec3 offset(const Vec3& v) const {
    return metres_per_unit * (is_mirrored ? Vec3(v.x(), v.y(), -v.z()) : v);
  }
  Quat rotation(const Quat& q) const {
    return is_mirrored ? Quat(q.w(), -q.x(), -q.y(), q.z()) : q;
  }
};

WorldTurn world_turn(const FbxSettings& settings) {
  WorldTurn world;
  world.metres_per_unit = settings.metres_per_unit;
  world.is_mirrored = settings.to_y_up.determinant() < 0.0;
  const Vec3 mirror(1.0, 1.0, world.is_mirrored ? -1.0 : 1.0);
  world.turn = Quat(Mat3(settings.to_y_up * mirror.asDiagonal())).normalized();
  return world;
}

void require_usable(const FbxScene& scene, const Vec3& position) {
  if (position.allFinite() && position.cwiseAbs().maxCoeff() < 1e9) return;
  throw Error({scene.document.file}, "a joint is too far away", "check the scales of the models");
}

FbxPlace child_place(const FbxScene& scene, const std::vector<FbxMoving>& moving,
                     const FbxPlace& parent, int model) {
  const auto m = static_cast<size_t>(model);
  return place_below(parent, scene.models[m], moving[m]);
}

std::vector<FbxPlace> places_of_figure(const FbxScene& scene, const FbxFigure& figure,
                                       const std::vector<FbxMoving>& moving) {
  FbxPlace top;
  for (const int model : figure.above) top = child_place(scene, moving, top, model);
  std::vector<FbxPlace> places;
  places.reserve(figure.joints.size());
  for (size_t j = 0; j < figure.joints.size(); ++j) {
    const FbxPlace& parent = j == 0 ? top : places[static_cast<size_t>(figure.parents[j])];
    places.push_back(child_place(scene, moving, parent, figure.joints[j]));
  }
  return places;
}

/// The position of a point in the frame of a model without its scales.
Vec3 seen_from(const FbxPlace& place, const Vec3& point) {
  return place.rotation.conjugate() * (point - place.position);
}

/// The names that are taken, with the number that the next one of the same name gets.
using TakenNames = std::map<std::string, int>;

std::string unique_name(const std::string& given, size_t joint, TakenNames& names) {
  const std::string own = given.empty() ? "joint_" + std::to_string(joint) : given;
  std::string name = own;
  while (names.contains(name)) {
    int& number = names[own];
    name = own + " " + std::to_string(++number);
  }
  names.emplace(name, 1);
  return name;
}

}  // namespace

Pose fbx_pose(const FbxScene& scene, const FbxFigure& figure,
              const std::vector<FbxMoving>& moving) {
  const WorldTurn world = world_turn(scene.settings);
  const std::vector<FbxPlace> places = places_of_figure(scene, figure, moving);
  Pose pose;
  pose.rotations.reserve(places.size());
  pose.offsets.reserve(places.size());
  pose.root_position = world.turn * world.offset(places.front().position);
  pose.rotations.push_back((world.turn * world.rotation(places.front().rotation)).normalized());
  pose.offsets.push_back(pose.root_position);
  for (size_t j = 1; j < places.size(); ++j) {
    const FbxPlace& parent = places[static_cast<size_t>(figure.parents[j])];
    const Quat local = parent.rotation.conjugate() * places[j].rotation;
    pose.rotations.push_back(world.rotation(local).normalized());
    pose.offsets.push_back(world.offset(seen_from(parent, places[j].position)));
  }
  for (const FbxPlace& place : places) {
    require_usable(scene, world.metres_per_unit * place.position);
  }
  return pose;
}

Skeleton fbx_skeleton(const FbxScene& scene, const FbxFigure& figure,
                      const std::vector<bool>& moved) {
  const std::vector<FbxMoving> rest = at_rest(scene);
  const std::vector<FbxPlace> places = places_of_figure(scene, figure, rest);
  const Pose pose = fbx_pose(scene, figure, rest);
  const WorldTurn world = world_turn(scene.settings);
  TakenNames names;
  Skeleton skeleton;
  for (size_t j = 0; j < figure.joints.size(); ++j) {
    Joint joint;
    const std::string& name = scene.models[static_cast<size_t>(figure.joints[j])].name;
    joint.name = unique_name(name, j, names);
    joint.parent = figure.parents[j];
    joint.offset = pose.offsets[j];
    skeleton.joints.push_back(std::move(joint));
  }
  const auto children = motion::children_of(skeleton);
  for (size_t j = 0; j < figure.joints.size(); ++j) {
    const int tip = children[j].empty() ? fbx_tip(scene, moved, figure.joints[j]) : -1;
    if (tip < 0) continue;
    const FbxPlace end = child_place(scene, rest, places[j], tip);
    require_usable(scene, world.metres_per_unit * end.position);
    skeleton.joints[j].tip = world.offset(seen_from(places[j], end.position));
  }
  return skeleton;
}

}  // namespace mien::motion
