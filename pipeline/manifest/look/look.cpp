#include "pipeline/manifest/look/look.h"

#include "scenes/figures/figure_colour.h"
#include "scenes/point_light/dot_display.h"

namespace mien::pipeline {

std::string scene_of(const Look& look) {
  if (!look.scene.empty()) return look.scene;
  return scenes::kind_of(look.figure).set;
}

scenes::Figure shown_figure(const Look& look) { return scenes::with_face(look.figure, look.face); }

scenes::SetPlan staged_set(const Look& look) {
  scenes::SetPlan plan = look.set;
  const auto show = [&](const render::Color& colour) {
    plan.sky.backdrop_horizon = plan.sky.backdrop_zenith = colour;
  };
  const scenes::PointLightOptions* dots = scenes::dots_in(look.figure);
  const bool is_bare = !plan.ground && look.background.empty();
  if (dots != nullptr && (look.scene.empty() || is_bare || !dots->background.empty())) {
    show(scenes::dot_colours(*dots).background);
  } else if (scenes::is_hex_colour(look.background)) {
    show(scenes::colour_from_hex(look.background));
  }
  return plan;
}

}  // namespace mien::pipeline
