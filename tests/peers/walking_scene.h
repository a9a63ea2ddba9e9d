#pragma once

// The scene that mien and its peers draw: a figure in the poses of the built-in walk, on a floor
// under one area light and an even sky. Here it is 21 spheres and 20 cylinders; walking_mannequin.h
// has a skinned mesh.

#include <cmath>
#include <vector>

#include "motion/procedural/builtin_sets.h"
#include "motion/skeleton/pose.h"
#include "render/tracer/tracer.h"

namespace mien::peers {

using render::Color;

inline constexpr int frames_in_all = 30;
inline constexpr float joint_radius = 0.055f;
inline constexpr float bone_radius = 0.035f;
inline constexpr float orbit_step = 0.02f;  // radians a frame

/// The walk, over and over; it lasts for more than frames_in_all.
using Walk = motion::Clip;

inline Walk walk() {
  return motion::repeated(motion::builtin_examples("walks-10").examples.front().clip, 3);
}

/// The pose of a frame, walking in place.
inline motion::Pose pose_at(const Walk& clip, int frame) {
  motion::Pose pose = clip.poses[static_cast<std::size_t>(frame)];
  pose.root_position.x() = pose.root_position.z() = 0.0;
  return pose;
}

struct Joints {
  std::vector<render::Vec3> places;
  std::vector<int> parents;
};

inline Joints joints_at(const Walk& clip, int frame) {
  Joints joints;
  const std::vector<motion::Vec3> places = motion::world_positions(clip.body, pose_at(clip, frame));
  for (std::size_t j = 0; j < places.size(); ++j) {
    joints.places.push_back(places[j].cast<float>());
    joints.parents.push_back(clip.body.joints[j].parent);
  }
  return joints;
}

/// Floor, light and sky, without a figure.
inline render::Scene empty_scene() {
  render::Scene scene;
  scene.ground.albedo = Color::Constant(0.5f);
  scene.ground.line_spacing = 0.0f;
  scene.ground.fade_start = 4000.0f;
  scene.ground.fade_end = 5000.0f;
  const Color sky = Color::Constant(0.6f);
  scene.sky = {sky, sky, Color::Zero(), sky, sky};
  scene.lights = {
      render::softbox({2.0f, 4.0f, 2.0f}, {0.0f, 1.0f, 0.0f}, 1.5f, 1.5f, Color::Constant(8.0f))};
  return scene;
}

inline render::Scene scene_of(const Joints& joints) {
  render::Scene scene = empty_scene();
  scene.materials = {{.albedo = {0.2f, 0.35f, 0.6f}}};
  for (std::size_t j = 0; j < joints.places.size(); ++j) {
    scene.solids.spheres.push_back({joints.places[j], joint_radius});
    if (joints.parents[j] < 0) continue;
    scene.solids.round_cones.push_back({joints.places[static_cast<std::size_t>(joints.parents[j])],
                                        joints.places[j], bone_radius, bone_radius});
  }
  return scene;
}

/// How the camera sees the figure: before it, round it by `orbit_step` a frame, or near its arm,
/// trunk and hips.
enum class View { standing, moving, close };

inline render::Camera camera_at(int frame, View view) {
  const float orbit = view == View::moving ? orbit_step * static_cast<float>(frame) : 0.0f;
  render::Camera camera{
      .position = {4.2f * std::sin(0.25f + orbit), 1.4f, 4.2f * std::cos(0.25f + orbit)},
      .target = {0.0f, 0.9f, 0.0f}};
  if (view == View::close) {
    camera.position = {-0.8f, 1.3f, 1.3f};
    camera.target = {0.0f, 1.05f, 0.0f};
  }
  camera.width = 1280;
  camera.height = 720;
  return camera;
}

}  // namespace mien::peers
