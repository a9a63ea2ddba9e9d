#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "motion/skeleton/clip.h"
#include "render/scene/camera.h"
#include "render/scene/scene.h"
#include "scenes/figures/figure.h"
#include "scenes/figures/figure_colour.h"
#include "scenes/point_light/point_light.h"

namespace mien::scenes {

/// Calls `draw`, which appends solids to a scene, and makes them a separate figure with this name
/// and opacity: solids of part 0 get a part "body" of the figure, and parts that `draw` appends
/// belong to the figure. In a scene without solids the figure takes the place of the scene's first,
/// empty figure.
void draw_as_figure(render::Scene& scene, const std::string& name, float opacity,
                    const std::function<void()>& draw);

/// One figure on the stage.
struct Actor {
  std::string name = "figure";  ///< as in the id layers of a picture
  motion::Clip clip;            ///< at the video's frame rate, not looping; metres
  FigureColours colours;
  double height_m = 1.75;
  float opacity = 1.0f;               ///< 0 … 1
  std::vector<Dot> dots;              ///< dots of a point-light figure or of markers
  std::optional<TrailOptions> trail;  ///< for figures that are shown in several poses
  std::vector<Dot> traces;            ///< dots whose paths a trail shows
  std::vector<std::string> warnings;  ///< of a character (Character::warnings)
  bool has_hands = true;              ///< whether fingers of the clip can be seen

  /// Appends the figure's materials and solids at a frame of its clip, as seen from a camera. The
  /// result depends only on the arguments; expensive preparations are done once for all frames.
  std::function<void(render::Scene& scene, const Actor& actor, int frame,
                     const render::Camera& camera)>
      draw;
};

/// Makes the actor of a clip; dots are placed when the stage is known (point_light,
/// marker_dots). Throws Error when the figure cannot be made for the clip.
Actor make_actor(const motion::Clip& clip, const Figure& figure, Role role,
                 MeshDetail detail = MeshDetail::full);

/// The same in other colours than those of a role.
Actor make_actor(const motion::Clip& clip, const Figure& figure, const FigureColours& colours,
                 MeshDetail detail);

/// Appends an actor to a scene as a separate figure. After the end of its clip the actor stands
/// still. A trail has the ghosts and traces of frame `made_at`.
void add_actor(render::Scene& scene, const Actor& actor, int frame, int made_at,
               const render::Camera& camera);

}  // namespace mien::scenes
