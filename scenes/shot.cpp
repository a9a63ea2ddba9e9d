#include "scenes/shot.h"

#include <algorithm>

#include "motion/error.h"
#include "scenes/sets.h"
#include "scenes/stick_figure.h"

namespace mien::scenes {

namespace {

/// How tall the figure is drawn: the body's stature, or the extent of whatever skeleton it is.
double height_of(const motion::Clip& clip, const Action& action) {
  if (motion::is_body(clip.body)) return motion::standing_height(clip.body);
  double height = 0.0;
  for (const motion::Vec3& point : action.points.front()) {
    height = std::max(height, (point - action.points.front().front()).norm());
  }
  return std::max(height, 0.2);
}

}  // namespace

std::vector<std::string> figure_names() { return {"stick"}; }

Shot stage(const motion::Clip& clip, const Look& look) {
  if (look.figure != "stick") {
    throw Error("there is no figure \"" + look.figure + "\"", "choose stick");
  }
  const Action action = action_of(clip);
  Shot shot;
  shot.clip = clip;
  shot.set = make_set(look.set, action.centre, action.forward);
  shot.cameras = make_camera_rig(look.camera, action, look.size);
  shot.colours = colours_of(look.role);
  shot.height_m = height_of(clip, action);
  return shot;
}

render::Scene scene_at(const Shot& shot, int frame) {
  render::Scene scene = shot.set;
  add_stick_figure(scene, shot.clip.body, shot.clip.poses[static_cast<size_t>(frame)], shot.colours,
                   shot.height_m);
  return scene;
}

render::Camera camera_at(const Shot& shot, int frame) { return shot.cameras.at(frame); }

}  // namespace mien::scenes
