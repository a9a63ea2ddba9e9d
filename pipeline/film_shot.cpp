#include "pipeline/film_shot.h"

#include "pipeline/look_checks.h"
#include "pipeline/synthesis.h"

namespace mien::pipeline {

namespace {

scenes::Role role_of(Role role) {
  switch (role) {
    case Role::target:
      return scenes::Role::target;
    case Role::reference:
      return scenes::Role::reference;
    default:
      return scenes::Role::created;
  }
}

}  // namespace

scenes::Shot shot_of(const Stimulus& stimulus, Motions& motions, std::uint64_t seed) {
  const scenes::SetPlan set = set_of(stimulus.look);
  Stimulus shown = stimulus;
  // A set that goes under the figure needs to know how fast it goes.
  if (set.in_place) shown.output.in_place = false;
  return scenes::stage(motions.shown(shown), {.set = set,
                                              .figure = stimulus.look.figure,
                                              .camera = stimulus.look.camera,
                                              .role = role_of(stimulus.role),
                                              .size = stimulus.output.size,
                                              .seed = seed});
}

}  // namespace mien::pipeline
