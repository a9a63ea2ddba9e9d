#pragma once

#include <array>

#include "render/scene/scene.h"
#include "scenes/mannequin/mannequin.h"

#include "peers/walking_scene.h"

namespace mien::peers {

/// How the surface of a mesh is shaded.
enum class Shading { smooth, flat };

/// The same triangles, with vertices and normals of their own.
inline render::Mesh flat_shaded(const render::Mesh& mesh) {
  render::Mesh flat = mesh;
  flat.positions.clear();
  flat.normals.clear();
  flat.uv.clear();
  for (std::array<int, 3>& triangle : flat.triangles) {
    std::array<render::Vec3, 3> corners;
    for (std::size_t i = 0; i < 3; ++i)
      corners[i] = mesh.positions[static_cast<std::size_t>(triangle[i])];
    const render::Vec3 across = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    for (std::size_t i = 0; i < 3; ++i) {
      flat.positions.push_back(corners[i]);
      flat.normals.push_back(across.normalized());
      flat.uv.push_back(mesh.uv[static_cast<std::size_t>(triangle[i])]);
      triangle[i] = static_cast<int>(flat.positions.size()) - 1;
    }
  }
  return flat;
}

/// The mannequin in the poses of the walk, in the scene of the sticks.
class WalkingMannequin {
 public:
  WalkingMannequin(const Walk& walk, Shading shading)
      : walk_(walk),
        shading_(shading),
        mannequin_(
            scenes::make_mannequin(walk.body, {}, scenes::colours_of(scenes::Role::created))) {}

  WalkingMannequin(const WalkingMannequin&) = delete;  // scenes refer to its paint
  WalkingMannequin& operator=(const WalkingMannequin&) = delete;

  /// Must not outlive this, nor this the walk.
  render::Scene scene_at(int frame) const {
    render::Scene scene = empty_scene();
    scenes::add_mannequin(scene, mannequin_, walk_.body, pose_at(walk_, frame));
    if (shading_ == Shading::flat) scene.solids.meshes[0] = flat_shaded(scene.solids.meshes[0]);
    return scene;
  }

 private:
  const Walk& walk_;
  Shading shading_;
  scenes::Mannequin mannequin_;
};

}  // namespace mien::peers
