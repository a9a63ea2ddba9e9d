#include "pipeline/study/live/live_bundle_writer.h"

#include <fmt/format.h>

#include "motion/error.h"
#include "pipeline/production/synthesis/slider_interface.h"

namespace mien::pipeline {

namespace {

motion::LiveTarget live_target(const std::string& id, Motions& motions) {
  const Stimulus* stimulus = motions.stimulus(id);
  if (stimulus == nullptr)
    throw Error(fmt::format("there is no stimulus \"{}\" for a target", id),
                "name stimuli of the manifest");
  const Synthesis& made = motions.of(id);
  motion::LiveTarget target;
  target.name = id;
  target.motion = made.motion;
  if (made.modified.empty()) target.weights = made.weights;
  target.playback = {stimulus->output.cycles, stimulus->output.in_place};
  target.shown_frames = motions.shown(*stimulus).frame_count();
  return target;
}

}  // namespace

LiveChoice live_choice(const Manifest& manifest) {
  return {{}, manifest.interpolation, manifest.output, {}};
}

motion::LiveBundle live_bundle(const Manifest& manifest, Motions& motions,
                               const LiveChoice& choice) {
  const Repertoire& repertoire = motions.repertoire();
  const motion::ExampleSet& examples = examples_for(choice.interpolation, repertoire);
  if (examples.examples.empty() || !examples.blendable)
    throw Error(Place{manifest.file.string()}, "its examples cannot be blended live",
                "use examples that can be blended, without blendable: false");
  motion::LiveBundle bundle;
  bundle.examples = examples;
  bundle.adjectives = repertoire.parameters;
  bundle.features = repertoire.features.table;
  bundle.feature_scale = repertoire.features.scale;
  bundle.how = choice.interpolation;
  bundle.frames_per_second = choice.output.fps;
  bundle.playback = {choice.output.cycles, choice.output.in_place};
  for (const std::string& id : choice.targets) bundle.targets.push_back(live_target(id, motions));
  bundle.info = live_info(bundle, repertoire.scales, choice.primary).dump();
  return bundle;
}

}  // namespace mien::pipeline
