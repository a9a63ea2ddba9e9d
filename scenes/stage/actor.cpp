#include "scenes/stage/actor.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>
#include <utility>

#include "motion/error.h"
#include "motion/skeleton/body.h"
#include "motion/skeleton/recorded_hands.h"
#include "motion/text/plain_number.h"
#include "scenes/character/character.h"
#include "scenes/face/character_face.h"
#include "scenes/face/hidden_face.h"
#include "scenes/figures/shown_hands.h"
#include "scenes/figures/stick_figure.h"
#include "scenes/mannequin/mannequin.h"
#include "scenes/point_light/dot_display.h"
#include "scenes/point_light/marker_dots.h"
#include "scenes/stage/trail_figure.h"

namespace mien::scenes {

namespace {

/// Assigns the part `body` to the solids from index `first` on whose part is still 0 (none).
template <class Solids>
void assign_part(Solids& solids, std::size_t first, int body) {
  for (std::size_t i = first; i < solids.size(); ++i) {
    if (solids[i].part == 0) solids[i].part = body;
  }
}

void require_body(const motion::Clip& clip, const std::string& figure) {
  if (motion::is_body(clip.body)) return;
  throw Error({clip.name}, figure + " needs a human body, which this motion does not have",
              "draw it as a stick figure");
}

/// Weights that would begin when the film has ended.
void require_weights_in(const motion::Clip& clip, const Face& face) {
  const double end = clip.frame_count() / clip.frames_per_second;
  if (face.file.empty() || face.start_s < end) return;
  throw Error({face.file.string()},
              "the weights of the face begin at " + motion::plain_number(face.start_s) +
                  " s, but the film ends at " +
                  motion::plain_number(std::round(100.0 * end) / 100.0) + " s",
              "let them begin earlier (start)");
}

Character shown(Character character, const Face& face) {
  return face.is_hidden ? with_hidden_face(std::move(character)) : character;
}

/// A mannequin that is made on first use, because a shot whose frames are not rendered needs none.
/// Thread-safe.
class LazyMannequin {
 public:
  LazyMannequin(motion::Skeleton body, const MannequinOptions& options,
                const FigureColours& colours, MeshDetail detail, MannequinHands hands)
      : body_(std::move(body)),
        options_(options),
        colours_(colours),
        detail_(detail),
        hands_(hands) {}

  const Mannequin& get() const {
    std::call_once(once_,
                   [this] { made_ = make_mannequin(body_, options_, colours_, detail_, hands_); });
    return *made_;
  }

 private:
  motion::Skeleton body_;
  MannequinOptions options_;
  FigureColours colours_;
  MeshDetail detail_;
  MannequinHands hands_;
  mutable std::once_flag once_;
  mutable std::optional<Mannequin> made_;
};

/// Sets an actor's draw function for its kind of figure.
struct ActorBuilder {
  Actor& actor;
  MeshDetail detail;

  void operator()(const StickOptions&) const {
    actor.draw = [](render::Scene& scene, const Actor& self, int frame, const render::Camera&) {
      add_stick_figure(scene, self.clip.body, self.clip.poses[static_cast<size_t>(frame)],
                       self.colours, self.height_m);
    };
  }

  void operator()(const MannequinOptions& options) const {
    require_body(actor.clip, "a mannequin");
    // Shared by the copies of the actor.
    const auto mannequin = std::make_shared<const LazyMannequin>(
        actor.clip.body, options, actor.colours, detail,
        motion::has_fingers(actor.clip) ? MannequinHands::fingers : MannequinHands::one_piece);
    actor.draw = [mannequin](render::Scene& scene, const Actor& self, int frame,
                             const render::Camera&) {
      add_mannequin(scene, mannequin->get(), self.clip.body,
                    self.clip.poses[static_cast<size_t>(frame)]);
    };
  }

  void operator()(const CharacterOptions& options) const {
    require_body(actor.clip, "a character");
    require_weights_in(actor.clip, options.face);
    const auto character = std::make_shared<const Character>(
        shown(scaled_to_body(read_character(options.file), actor.clip.body), options.face));
    // It has a stature of its own, which the camera has to know.
    actor.clip = retargeted_to(*character, actor.clip);
    actor.height_m = figure_height(actor.clip);
    const auto face = std::make_shared<const FaceMotion>(
        *character, options.face, actor.clip.frame_count(), actor.clip.frames_per_second);
    actor.has_hands =
        std::ranges::any_of(character->fingers.joints, [](int joint) { return joint >= 0; });
    actor.warnings = character->warnings;
    actor.warnings.insert(actor.warnings.end(), face->warnings().begin(), face->warnings().end());
    actor.draw = [character, face](render::Scene& scene, const Actor& self, int frame,
                                   const render::Camera&) {
      add_character(scene, *character, self.clip.poses[static_cast<size_t>(frame)], face->at(frame),
                    face->turns_at(frame));
    };
  }

  void operator()(const PointLightOptions& options) const {
    actor.draw = [options](render::Scene& scene, const Actor& self, int frame,
                           const render::Camera& camera) {
      add_dots(scene, self.dots, frame, options, camera);
    };
  }

  void operator()(const MarkersOptions& options) const {
    const std::vector<Limb> pairs =
        options.dots.lifetime > 0 ? std::vector<Limb>() : shown_markers(actor.clip, options).pairs;
    actor.draw = [dots = options.dots, pairs](render::Scene& scene, const Actor& self, int frame,
                                              const render::Camera& camera) {
      if (!pairs.empty()) add_sticks(scene, self.dots, pairs, frame, dots, camera);
      add_dots(scene, self.dots, frame, dots, camera);
    };
  }

  void operator()(const TrailOptions& options) const {
    std::visit(*this, options.figure);
    actor.trail = options;
  }
};

}  // namespace

Actor make_actor(const motion::Clip& clip, const Figure& figure, Role role, MeshDetail detail) {
  return make_actor(clip, figure, colours_of(role), detail);
}

Actor make_actor(const motion::Clip& clip, const Figure& figure, const FigureColours& colours,
                 MeshDetail detail) {
  Actor actor;
  actor.clip = clip;
  actor.colours = colours;
  actor.height_m = figure_height(clip);
  std::visit(ActorBuilder{actor, detail}, figure);
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

void draw_as_figure(render::Scene& scene, const std::string& name, float opacity,
                    const std::function<void()>& draw) {
  if (!scene.solids.empty()) {
    scene.figures.emplace_back();
    scene.parts.push_back({"body", static_cast<int>(scene.figures.size()) - 1});
  }
  const auto figure = static_cast<int>(scene.figures.size()) - 1;
  const auto body = static_cast<int>(scene.parts.size()) - 1;
  scene.figures.back() = {name, opacity};
  const std::size_t spheres = scene.solids.spheres.size();
  const std::size_t round_cones = scene.solids.round_cones.size();
  const std::size_t meshes = scene.solids.meshes.size();
  draw();
  for (std::size_t p = static_cast<std::size_t>(body) + 1; p < scene.parts.size(); ++p) {
    scene.parts[p].figure = figure;
  }
  assign_part(scene.solids.spheres, spheres, body);
  assign_part(scene.solids.round_cones, round_cones, body);
  assign_part(scene.solids.meshes, meshes, body);
}

}  // namespace mien::scenes
