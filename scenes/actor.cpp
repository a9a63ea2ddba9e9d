#include "scenes/actor.h"

#include <algorithm>

#include "motion/error.h"
#include "scenes/dot_display.h"
#include "scenes/figure_height.h"
#include "scenes/figure_scope.h"
#include "scenes/stick_figure.h"
#include "scenes/trail_figure.h"

namespace mien::scenes {

namespace {

/// Gives an actor the way in which its kind of figure is drawn.
struct Casting {
  Actor& actor;
  const DotStage& stage;

  void operator()(const StickOptions&) const {
    actor.draw = [](render::Scene& scene, const Actor& self, int frame, const render::Camera&) {
      add_stick_figure(scene, self.clip.body, self.clip.poses[static_cast<size_t>(frame)],
                       self.colours, self.height_m);
    };
  }

  void operator()(const MannequinOptions&) const {
    throw Error("the mannequin cannot be drawn yet", "choose stick");
  }

  void operator()(const CharacterOptions&) const {
    throw Error("characters cannot be drawn yet", "choose stick");
  }

  void operator()(const PointLightOptions& options) const {
    actor.dots = point_light(actor.clip, options, stage);
    actor.draw = [options](render::Scene& scene, const Actor& self, int frame,
                           const render::Camera& camera) {
      add_dots(scene, self.dots, frame, options, camera);
    };
  }

  void operator()(const TrailOptions& options) const {
    std::visit(*this, options.figure);
    actor.trail = options;
  }
};

}  // namespace

Actor cast(const motion::Clip& clip, const Figure& figure, Role role, const DotStage& stage) {
  Actor actor;
  actor.clip = clip;
  actor.colours = colours_of(role);
  actor.height_m = figure_height(clip);
  std::visit(Casting{actor, stage}, figure);
  return actor;
}

void add_actor(render::Scene& scene, const Actor& actor, int frame, const render::Camera& camera) {
  const int shown = std::min(frame, actor.clip.frame_count() - 1);
  if (actor.trail) return add_trail(scene, actor, *actor.trail, shown, camera);
  draw_as_figure(scene, actor.name, actor.opacity,
                 [&] { actor.draw(scene, actor, shown, camera); });
}

}  // namespace mien::scenes
