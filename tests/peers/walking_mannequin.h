#pragma once

#include "scenes/mannequin/mannequin.h"

#include "peers/walking_scene.h"

namespace mien::peers {

/// The mannequin in the poses of the walk, in the scene of the sticks.
class WalkingMannequin {
 public:
  explicit WalkingMannequin(const Walk& walk)
      : walk_(walk),
        mannequin_(
            scenes::make_mannequin(walk.body, {}, scenes::colours_of(scenes::Role::created))) {}

  WalkingMannequin(const WalkingMannequin&) = delete;  // scenes refer to its paint
  WalkingMannequin& operator=(const WalkingMannequin&) = delete;

  /// Must not outlive this, nor this the walk.
  render::Scene scene_at(int frame) const {
    render::Scene scene = empty_scene();
    scenes::add_mannequin(scene, mannequin_, walk_.body, pose_at(walk_, frame));
    return scene;
  }

 private:
  const Walk& walk_;
  scenes::Mannequin mannequin_;
};

}  // namespace mien::peers
