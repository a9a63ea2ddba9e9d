#include "scenes/actor.h"

#include <algorithm>
#include <memory>
#include <string>

#include "motion/error.h"
#include "scenes/character.h"
#include "scenes/dot_display.h"
#include "scenes/figure_height.h"
#include "scenes/figure_scope.h"
#include "scenes/mannequin.h"
#include "scenes/stick_figure.h"
#include "scenes/trail_figure.h"

namespace mien::scenes {

namespace {

void require_body(const motion::Clip& clip, const std::string& figure) {
  if (motion::is_body(clip.body)) return;
  throw Error({clip.name}, figure + " needs a human body, and this motion has none",
              "draw it as a stick figure");
}

Character character_for(const motion::Clip& clip, const CharacterOptions& options) {
  require_body(clip, "a character");
  return fitted(read_character(options.file), clip.body);
}

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
    const auto character = std::make_shared<const Character>(character_for(actor.clip, options));
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

/// The character that a figure, or a trail's figure, is.
const CharacterOptions* character_in(const Figure& figure) {
  if (const auto* trail = std::get_if<TrailOptions>(&figure)) {
    return std::get_if<CharacterOptions>(&trail->figure);
  }
  return std::get_if<CharacterOptions>(&figure);
}

}  // namespace

motion::Clip worn_by(const Figure& figure, const motion::Clip& clip) {
  const CharacterOptions* character = character_in(figure);
  return character ? worn_by(character_for(clip, *character), clip) : clip;
}

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
