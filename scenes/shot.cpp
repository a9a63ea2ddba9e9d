#include "scenes/shot.h"

#include <algorithm>

#include "scenes/sets.h"

namespace mien::scenes {

namespace {

/// Draws an actor as a figure of its own, whose parts are its own.
void add_actor(render::Scene& scene, const Actor& actor, int frame) {
  const int last = actor.clip.frame_count() - 1;
  actor.draw(scene, actor, std::min(frame, last));
}

}  // namespace

int Shot::frame_count() const {
  int most = 0;
  for (const Actor& actor : actors) most = std::max(most, actor.clip.frame_count());
  return most;
}

Shot stage(const motion::Clip& clip, const Look& look) {
  const Action action = action_of(clip);
  Shot shot;
  shot.actors.push_back(cast(clip, look.figure, look.role));
  shot.set = make_set(look.set, action.centre, action.forward);
  shot.cameras = make_camera_rig(look.camera, action, look.size);
  return shot;
}

render::Scene scene_at(const Shot& shot, int frame) {
  render::Scene scene = shot.set;
  for (const Actor& actor : shot.actors) add_actor(scene, actor, frame);
  return scene;
}

render::Camera camera_at(const Shot& shot, int frame) { return shot.cameras.at(frame); }

}  // namespace mien::scenes
