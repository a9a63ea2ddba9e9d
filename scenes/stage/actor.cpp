#include "scenes/stage/actor.h"

#include <algorithm>
#include <memory>
#include <string>

#include "motion/error.h"
#include "motion/skeleton/body.h"
#include "scenes/character/character.h"
#include "scenes/figures/figure_height.h"
#include "scenes/figures/stick_figure.h"
#include "scenes/mannequin/mannequin.h"
#include "scenes/point_light/dot_display.h"
#include "scenes/stage/figure_scope.h"
#include "scenes/stage/trail_figure.h"

namespace mien::scenes {

namespace {

void require_body(const motion::Clip& clip, const std::string& figure) {
  if (motion::is_body(clip.body)) return;
  throw Error({clip.name}, figure + " needs a human body, and this motion has none",
              "draw it as a stick figure");
}

/// Gives an actor the way in which its kind of figure is drawn.
struct Casting {
  Actor& actor;

  void operator()(const StickOptions&) const {
    actor.draw = [](render::Scene& scene, const Actor& self, int frame, const render::Camera&) {
      add_stick_figure(scene, self.clip.body, self.clip.poses[static_cast<size_t>(frame)],
                       self.colours, self.height_m);
    };
  }

  void operator()(const MannequinOptions& options) const {
    require_body(actor.clip, "a mannequin");
    // Shared by the copies of the actor; nobody changes it.
    const auto mannequin =
        std::make_shared<const Mannequin>(make_mannequin(actor.clip.body, options, actor.colours));
    actor.draw = [mannequin](render::Scene& scene, const Actor& self, int frame,
                             const render::Camera&) {
      add_mannequin(scene, *mannequin, self.clip.body, self.clip.poses[static_cast<size_t>(frame)]);
    };
  }

  void operator()(const CharacterOptions& options) const {
    require_body(actor.clip, "a character");
    const auto character =
        std::make_shared<const Character>(fitted(read_character(options.file), actor.clip.body));
    // It has a stature of its own, which the camera has to know.
    actor.clip = worn_by(*character, actor.clip);
    actor.height_m = figure_height(actor.clip);
    actor.warnings = character->warnings;
    actor.draw = [character](render::Scene& scene, const Actor& self, int frame,
                             const render::Camera&) {
      add_character(scene, *character, self.clip.poses[static_cast<size_t>(frame)]);
    };
  }

  void operator()(const PointLightOptions& options) const {
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

Actor cast(const motion::Clip& clip, const Figure& figure, Role role) {
  Actor actor;
  actor.clip = clip;
  actor.colours = colours_of(role);
  actor.height_m = figure_height(clip);
  std::visit(Casting{actor}, figure);
  return actor;
}

void add_actor(render::Scene& scene, const Actor& actor, int frame, int made_at,
               const render::Camera& camera) {
  const int last = actor.clip.frame_count() - 1;
  const int shown = std::min(frame, last);
  if (actor.trail) {
    return add_trail(scene, actor, *actor.trail, shown, std::min(made_at, last), camera);
  }
  draw_as_figure(scene, actor.name, actor.opacity,
                 [&] { actor.draw(scene, actor, shown, camera); });
}

}  // namespace mien::scenes
