#include "scenes/shot.h"

#include <algorithm>

#include "scenes/travel.h"

namespace mien::scenes {

namespace {

/// Draws an actor as a figure of its own, whose parts are its own.
void add_actor(render::Scene& scene, const Actor& actor, int frame, const render::Camera& camera) {
  const int last = actor.clip.frame_count() - 1;
  actor.draw(scene, actor, std::min(frame, last), camera);
}

}  // namespace

int Shot::frame_count() const {
  int most = 0;
  for (const Actor& actor : actors) most = std::max(most, actor.clip.frame_count());
  return most;
}

Shot stage(const motion::Clip& clip, const Look& look) {
  Shot shot;
  shot.set = look.set;
  shot.place.forward = action_of(clip).forward;
  if (look.set.in_place) shot.step = mean_step(clip);
  shot.actors.push_back(cast(on_the_spot(clip, shot.step), look.figure, look.role));
  Action action = action_of(shot.actors.front().clip);
  action.forward = shot.place.forward;
  shot.place.centre = action.centre;
  shot.standing = standing_set(shot.set, shot.place);
  shot.cameras = make_camera_rig(look.camera, action, look.size);
  return shot;
}

render::Scene scene_at(const Shot& shot, int frame) {
  render::Scene scene = shot.standing;
  const render::Camera& camera = shot.cameras.at(frame);
  add_walls(scene, shot.set, shot.place, camera.position.cast<double>());
  if (shot.set.in_place) add_moving_ground(scene, shot.set, shot.place, -frame * shot.step);
  for (const Actor& actor : shot.actors) add_actor(scene, actor, frame, camera);
  return scene;
}

render::Camera camera_at(const Shot& shot, int frame) { return shot.cameras.at(frame); }

}  // namespace mien::scenes
