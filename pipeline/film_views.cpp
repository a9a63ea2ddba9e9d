#include "pipeline/film_views.h"

#include "pipeline/csv.h"
#include "pipeline/look_checks.h"
#include "pipeline/synthesis.h"
#include "scenes/camera_rig.h"
#include "scenes/travel.h"

namespace mien::pipeline {

namespace {

/// What the camera of a stimulus has to see.
scenes::Action action_of(const Stimulus& stimulus, Motions& motions) {
  const bool is_in_place = set_of(stimulus.look).in_place;
  Output shown = stimulus.output;
  if (is_in_place) shown.in_place = false;
  const motion::Clip clip = shown_clip(motions.of(stimulus.id), shown);
  scenes::Action action = scenes::action_of(clip);
  if (!is_in_place) return action;
  const motion::Vec3 forward = action.forward;
  action = scenes::action_of(scenes::on_the_spot(clip, scenes::mean_step(clip)));
  action.forward = forward;
  return action;
}

}  // namespace

std::string views_csv(const Manifest& manifest, Motions& motions) {
  CsvWriter table({"stimulus", "figure_px", "visual_degrees"});
  for (const Stimulus& stimulus : manifest.stimuli) {
    const scenes::Action action = action_of(stimulus, motions);
    const scenes::CameraSettings& settings = stimulus.look.camera;
    const render::Camera camera =
        scenes::make_camera_rig(settings, action, stimulus.output.size).at(0);
    const double degrees = scenes::visual_degrees(camera, action.centre, action.height_m);
    table.row({stimulus.id, shortest(scenes::figure_pixels(camera, action.centre, action.height_m)),
               settings.screen ? shortest(degrees) : ""});
  }
  return table.text();
}

}  // namespace mien::pipeline
