#include <memory>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "motion/formats/motion_file.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/commands/line/recording_options.h"
#include "pipeline/commands/motion/change.h"
#include "pipeline/commands/motion/motion.h"
#include "pipeline/manifest/reading/recipes.h"
#include "pipeline/production/synthesis/modified_motion.h"
#include "pipeline/production/synthesis/synthesis.h"

namespace mien::pipeline {

namespace {

struct ModifyOptions {
  std::string in;
  std::string out;
  std::string change;
  RecordingArguments recording;
  std::string recipes = "builtin";
  std::string on_fault = "warn";
  double fps = 0.0;
};

int modify_file(const ModifyOptions& options, const Console& console) {
  const NamedRecording named = named_recording(options.in, options.recording);
  refuse_own_inputs({named.file, named.how.body_model, options.recipes}, options.out);
  Stimulus stimulus = stimulus_of({named.file, options.change, options.recipes, options.on_fault});
  for (const ModificationStep& step : stimulus.modify)
    if (step.pose) refuse_own_inputs({step.pose->neutral.file, step.pose->posed.file}, options.out);
  stimulus.clip->how = {named.how.take.value_or(""), named.how.subject.value_or(""),
                        named.how.frames_per_second, named.how.joints, named.how.body_model};
  stimulus.output.fps = options.fps > 0.0
                            ? options.fps
                            : motion::read_motion(named.file, named.how).frames_per_second;
  const Synthesis made = synthesize(stimulus, {});
  motion::write_motion(motion::to_recording(made.motion.clip), options.out);
  console.out << fmt::format("{}: {}{}, {} frames\n", options.out, made.modified,
                             share_text(made.modified_share), made.motion.clip.frame_count());
  for (const std::string& note : made.notes) console.out << "  " << note << '\n';
  for (const std::string& warning : made.warnings) console.err << "warning: " << warning << '\n';
  return exit_done;
}

void list_emotions(const RecipeBook& book, const Console& console) {
  if (!book.name.empty()) console.out << book.name << "\n";
  for (const Recipe& recipe : book.recipes) {
    ModificationStep step;
    step.edit = recipe.edit;
    console.out << fmt::format("  {:15} {}{}\n", recipe.name, described(step),
                               recipe.note.empty() ? "" : " (" + recipe.note + ")");
  }
}

int emotions(const std::string& recipes, bool as_yaml, bool posture, const Console& console) {
  if (posture) {
    for (const motion::PostureUnitName& unit : motion::posture_units())
      console.out << fmt::format("{:28} {}\n", unit.name, unit.description);
    return exit_done;
  }
  const RecipeBook book = read_recipes(recipes, recipes);
  const std::string_view text = builtin_recipes_text(recipes);
  if (as_yaml) {
    console.out << (text.empty() ? read_file(recipes) : std::string(text));
  } else {
    list_emotions(book, console);
  }
  return exit_done;
}

/// What `--recipes` accepts.
constexpr const char* named_recipes =
    "builtin, builtin@0.2 or builtin@0.3 (those of mien 0.2 or 0.3), fig29 (after figure 29 of a "
    "thesis on emotion in motion capture), or a file of recipes";

}  // namespace

Command motion_modify_command() {
  const auto options = std::make_shared<ModifyOptions>();
  return {
      .name = "modify",
      .summary = "Change the emotional content of a captured motion",
      .options = all_of(
          argument("in", &options->in, "Motion file"),
          argument("change", &options->change,
                   "An emotion, or the value of `modify:` in a manifest"),
          argument("out", &options->out, "File to write: " + motion::formats_written()),
          recording_options(options->recording),
          option("--recipes", &options->recipes, named_recipes).with_default(),
          option(
              "--on-fault", &options->on_fault,
              "If the change makes the motion faulty: warn: write it with a warning; fail: stop; "
              "revert: write the unmodified motion; reduce: reduce the strength until there is "
              "no fault")
              .one_of({"warn", "fail", "revert", "reduce"})
              .with_default(),
          option("--fps", &options->fps, "Frames per second to write (default: that of the file)")
              .between(1.0, 1000.0)),
      .notes =
          "The result has the canonical body (21 joints, metres, +Y up). Changes that refer to "
          "examples (method:,\n"
          "pose: of an example) require a manifest.\n\nExamples:\n"
          "  mien motion modify walk.bvh sad sad.bvh\n"
          "  mien motion modify walk.bvh 'emotion: angry, strength: 0.6' angry.glb\n"
          "  mien motion modify walk.bvh '[{emotion: sad}, {tempo: 1.2}]' brisk-sad.bvh\n"
          "  mien motion modify dance.c3d sad sad.bvh --subject Anna\n"
          "  mien motion modify walk.bvh 'keys: [{at: 1.2 s, right-hand: [-0.3, 1.4, 0.4]}]' "
          "raised.bvh\n"
          "  mien motion modify walk.bvh 'paths: 1.4, posture: {head-flexion: 12}' longer.bvh",
      .run = [options](const Console& console) { return modify_file(*options, console); }};
}

Command motion_emotions_command() {
  struct Options {
    std::string recipes = "builtin";
    bool yaml = false;
    bool posture = false;
  };
  const auto options = std::make_shared<Options>();
  return {.name = "emotions",
          .summary = "List the emotions that can be applied to motions",
          .options = {option("--recipes", &options->recipes, named_recipes).with_default(),
                      flag("--yaml", &options->yaml, "Print the recipes as a recipes file"),
                      flag("--posture", &options->posture,
                           "List the rotations that can be named in `posture:`")},
          .notes =
              "To start your own file of recipes:\n"
              "  mien motion emotions --yaml > my.recipes.yaml",
          .run = [options](const Console& console) {
            return emotions(options->recipes, options->yaml, options->posture, console);
          }};
}

}  // namespace mien::pipeline
