#include "pipeline/production/film/film_shot.h"

#include "motion/skeleton/clip.h"
#include "pipeline/manifest/derived_seed.h"
#include "pipeline/manifest/look/look.h"

namespace mien::pipeline {

namespace {

scenes::Look look_of(const Stimulus& film, std::uint64_t seed) {
  scenes::Look look = staged_look(film.look, film.output, derived_seed(seed, "dots of " + film.id));
  look.role = film_role(film);
  return look;
}

/// What is shown of a motion that was made for another film, which may have another frame rate.
motion::Clip clip_at_rate(const motion::Clip& made, const Output& output) {
  return playback_clip(motion::resampled(made, output.fps), output);
}

/// Output of a clip for a set. A set that moves under the figure needs the figure's speed.
Output output_for(Output output, const scenes::SetPlan& set) {
  if (set.in_place) output.in_place = false;
  return output;
}

}  // namespace

scenes::Look staged_look(const Look& look, const Output& output, std::uint64_t seed) {
  return {.set = staged_set(look),
          .figure = look.figure,
          .camera = look.camera,
          .size = output.whole_size(),
          .window = output.window(),
          .pixel_scale = output.scale,
          .detail = output.quality == Quality::draft ? scenes::MeshDetail::draft
                                                     : scenes::MeshDetail::full,
          .seed = seed};
}

Role film_role(const Stimulus& stimulus) {
  return stimulus.look.colours == Colours::role ? stimulus.role : Role::neutral;
}

motion::Clip staged_clip(const Stimulus& stimulus, FinishedMotions& motions) {
  Stimulus shown = stimulus;
  shown.output = output_for(shown.output, staged_set(stimulus.look));
  return motions.shown(shown);
}

scenes::Shot shot_of(const Stimulus& stimulus, FinishedMotions& motions, std::uint64_t seed,
                     const Framing& framing) {
  return shot_of(stimulus, staged_clip(stimulus, motions), seed, framing);
}

scenes::Shot shot_of(const Stimulus& stimulus, const motion::Clip& clip, std::uint64_t seed,
                     const Framing& framing) {
  scenes::Look look = look_of(stimulus, seed);
  if (framing.figure_px) look.camera.figure_px = *framing.figure_px / look.pixel_scale;
  look.figure_place = framing.figure_place;
  return scenes::stage(clip, look);
}

scenes::Shot shot_of(const Overlay& overlay, FinishedMotions& motions, std::uint64_t seed) {
  scenes::Look look = look_of(overlay.film, seed);
  look.layout = overlay.layout;
  const Output output = output_for(overlay.film.output, look.set);
  const bool is_clear = overlay.layout != scenes::Layout::superimposed;
  std::vector<scenes::Performance> performances;
  for (const auto& [role, name] : motions_on(overlay)) {
    performances.push_back({.name = name,
                            .clip = clip_at_rate(motions.clip(name), output),
                            .role = role,
                            .opacity = is_clear ? 1.0f : static_cast<float>(overlay.opacity)});
  }
  return scenes::stage(performances, look);
}

}  // namespace mien::pipeline
