#include <algorithm>
#include <memory>
#include <string>

#include <fmt/format.h>

#include "motion/formats/motion_file.h"
#include "motion/text/nearest_word.h"
#include "pipeline/commands/line/examples_option.h"
#include "pipeline/commands/line/recording_options.h"
#include "pipeline/commands/motion/motion.h"
#include "pipeline/manifest/example_files.h"
#include "pipeline/manifest/reading/example_source.h"
#include "pipeline/production/clips/finished_motions.h"
#include "pipeline/production/synthesis/blend_warnings.h"
#include "pipeline/production/synthesis/repertoire.h"
#include "pipeline/production/synthesis/synthesis.h"

namespace mien::pipeline {

namespace {

struct BlendCommandOptions {
  std::string examples;
  RecordingArguments recording;
  std::string weights;
  std::string out;
  double fps = 30.0;
  int cycles = 1;
  bool in_place = false;
  bool no_foot_lock = false;
};

void refuse_unknown(const NamedValues& weights, const std::vector<std::string>& names) {
  for (const auto& [name, value] : weights) {
    if (std::find(names.begin(), names.end(), name) != names.end()) continue;
    throw Error("--weights: there is no example \"" + name + "\"",
                motion::did_you_mean(name, names));
  }
}

int blend(const BlendCommandOptions& options, const Console& console) {
  Manifest manifest;
  manifest.examples = examples_of(options.examples, options.recording);
  refuse_own_inputs(repertoire_files(manifest), options.out);
  Stimulus stimulus;
  stimulus.id = "blend";
  stimulus.weights = parse_weights(options.weights);
  stimulus.output.fps = options.fps;
  stimulus.output.cycles = options.cycles;
  stimulus.output.in_place = options.in_place;
  stimulus.interpolation.foot_lock = !options.no_foot_lock;
  refuse_unknown(stimulus.weights, example_names(manifest));

  const Repertoire repertoire = load_repertoire(manifest);
  const Synthesis synthesis = synthesize(stimulus, repertoire);
  const motion::Clip shown = playback_clip(synthesis.motion.clip, stimulus.output);
  motion::write_motion(motion::to_recording(shown), options.out);
  for (const std::string& warning : blend_warnings(repertoire, synthesis))
    console.err << "warning: " << warning << '\n';
  console.out << options.out << ": " << shown.frame_count() << " frames\n";
  return exit_done;
}

}  // namespace

Command motion_blend_command() {
  const auto options = std::make_shared<BlendCommandOptions>();
  return {
      .name = "blend",
      .summary = "Blend motions by weights",
      .options = all_of(
          option("--examples", &options->examples, examples_help).required(),
          recording_options(options->recording),
          option("--weights", &options->weights, "Weights by name: normal=0.6,proud=0.4")
              .required(),
          option("-o,--output", &options->out, "File to write: " + motion::formats_written())
              .required(),
          option("--fps", &options->fps, "Frames per second").between(1.0, 240.0).with_default(),
          option("--cycles", &options->cycles, "Repetitions of a loop")
              .between(1, 1000)
              .with_default(),
          flag("--in-place", &options->in_place, "Walk in place"),
          flag("--no-foot-lock", &options->no_foot_lock, "Do not lock planted feet to the floor")),
      .notes =
          "Example:\n  mien motion blend --examples builtin:walks-10 --weights happy=0.7,tired=0.3 "
          "-o mix.bvh",
      .run = [options](const Console& console) { return blend(*options, console); }};
}

}  // namespace mien::pipeline
