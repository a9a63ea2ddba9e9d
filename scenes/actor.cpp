#include "scenes/actor.h"

#include <algorithm>
#include <memory>
#include <string>

#include "motion/body.h"
#include "motion/error.h"
#include "scenes/character.h"
#include "scenes/mannequin.h"
#include "scenes/stick_figure.h"

namespace mien::scenes {

namespace {

/// How tall the figure is drawn: the body's stature, or the extent of whatever skeleton it is.
double height_of(const motion::Clip& clip) {
  if (motion::is_body(clip.body)) return motion::standing_height(clip.body);
  const motion::JointTransforms world = motion::world_transforms(clip.body, clip.poses.front());
  double height = 0.0;
  const auto reach = [&](const motion::Vec3& point) {
    height = std::max(height, (point - world.positions.front()).norm());
  };
  for (size_t j = 0; j < world.positions.size(); ++j) {
    reach(world.positions[j]);
    const auto& tip = clip.body.joints[j].tip;
    if (tip) reach(world.positions[j] + world.rotations[j] * *tip);
  }
  return std::max(height, 0.2);
}

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
    actor.height_m = height_of(actor.clip);
    actor.warnings = character->warnings;
    actor.draw = [character](render::Scene& scene, const Actor& self, int frame,
                             const render::Camera&) {
      add_character(scene, *character, self.clip.poses[static_cast<size_t>(frame)]);
    };
  }

  void operator()(const PointLightOptions&) const {
    throw Error("point lights cannot be drawn yet", "choose stick");
  }

  void operator()(const TrailOptions&) const {
    throw Error("trails cannot be drawn yet", "choose stick");
  }
};

}  // namespace

Actor cast(const motion::Clip& clip, const Figure& figure, Role role) {
  Actor actor;
  actor.clip = clip;
  actor.colours = colours_of(role);
  actor.height_m = height_of(clip);
  std::visit(Casting{actor}, figure);
  return actor;
}

}  // namespace mien::scenes
