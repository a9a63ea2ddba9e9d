#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "motion/formats/motion_file.h"
#include "motion/text/as_number.h"
#include "motion/text/excerpt.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/commands/line/console.h"
#include "pipeline/commands/line/production_options.h"
#include "pipeline/commands/line/recording_options.h"
#include "pipeline/commands/render_options.h"
#include "pipeline/commands/render_performances.h"
#include "pipeline/manifest/look/look_checks.h"
#include "pipeline/manifest/look/look_options.h"
#include "pipeline/production/film/film.h"
#include "pipeline/production/film/film_dots.h"
#include "pipeline/production/film/film_shot.h"
#include "pipeline/production/film/shot_files.h"
#include "pipeline/tasks/progress.h"
#include "render/error.h"
#include "scenes/character/character.h"
#include "scenes/stage/shot.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

constexpr double small_figure = 0.25;  // of the picture's height

/// The whole film as one task, for the progress bar.
TaskGraph one_task(const std::string& name) {
  TaskGraph graph;
  Task task;
  task.id = name;
  task.products.push_back({name, {}});
  task.cost_seconds = 1.0;
  graph.add(std::move(task));
  return graph;
}

render::Background background_of(const RenderOptions& options) {
  return options.background == "shadow"        ? render::Background::shadow
         : options.background == "transparent" ? render::Background::transparent
                                               : render::Background::shown;
}

/// The frame of a still: the last one for a trail, which is complete then; otherwise the middle
/// one.
int still_frame(const scenes::Shot& shot, const RenderOptions& options, double fps) {
  const int last = shot.frame_count() - 1;
  const std::string moment = options.still.value_or("middle");
  if (moment == "middle") return shot.actors.front().trail ? last : last / 2;
  const double seconds = motion::as_number<double>(moment).value_or(-1.0);
  if (!(seconds >= 0.0 && seconds * fps < last + 1.0))
    throw Error(fmt::format("--still: {} is outside the motion", motion::in_quotes(moment)),
                fmt::format("write seconds from 0 to {:.2f}, or omit the number", last / fps));
  return std::min(static_cast<int>(std::lround(seconds * fps)), last);
}

/// Prints the figure's size if a screen is given or the figure is unusually small.
void print_size(const scenes::Shot& shot, const Look& look, const Console& console) {
  const render::Camera& camera = camera_at(shot, 0);
  const double pixels = scenes::figure_pixels(shot.cameras);
  if (look.camera.screen) {
    console.out << fmt::format("  standing figure: {:.1f} degrees of visual angle, {:.0f} pixels\n",
                               scenes::visual_degrees(shot.cameras), pixels);
  } else if (shot.cameras.cameras.size() == 1 && pixels < small_figure * camera.height &&
             shot.step.isZero() && !look.camera.figure_px && !look.camera.position) {
    console.err << fmt::format(
        "note: the figure is only {:.0f} of {} pixels tall because its whole path has to be in the "
        "image; use --camera follow or --in-place to show it larger\n",
        pixels, camera.height);
  }
}

void write_dots(const scenes::Shot& shot, const fs::path& file) {
  make_folder(file.parent_path());
  write_file(file, dots_csv(shot));
}

scenes::Shot shot_of(const RenderOptions& options, const RenderPlan& plan, const Console& console) {
  const Output& output = plan.settings.output;
  const RenderedMotions motions = rendered_motions(options, output, console);
  scenes::Look look = staged_look(plan.look, output, options.seed);
  look.in_place = output.in_place;
  look.layout = motions.layout;
  return scenes::stage(motions.performances, look);
}

/// Renders the file with a progress bar. Returns a description of it.
std::string make_file(const RenderOptions& options, const RenderPlan& plan,
                      const scenes::Shot& shot, const Console& console) {
  const TaskGraph graph = one_task(plan.out.string());
  make_folder(plan.out.parent_path());
  ResultFile result(plan.out);
  std::string found;
  Progress bar(console.err, console.err_is_terminal, graph, std::vector<TaskOutcome>(1),
               steady_seconds);
  const RunObserver observer = bar.observer();
  const ShotWork work{shot, plan.settings, console.stop,
                      [&](double share) { observer.progressed(graph.tasks[0], share); }};
  try {
    if (is_still(options, plan)) {
      const int frame = still_frame(shot, options, plan.settings.output.fps);
      write_still(work, frame, background_of(options), result.draft());
      found = fmt::format("frame {}", frame);
    } else {
      found = (is_picture(plan.out) ? write_contact_sheet : write_video)(work, result.draft());
    }
  } catch (const render::Error& wrong) {
    throw render::Error(result.with_target_name(wrong.what()));
  }
  result.publish();
  return found;
}

/// Throws Error if a file to be written is an input, or the other file to be written.
void refuse_lost_files(const RenderOptions& options, const RenderPlan& plan) {
  const fs::path& out = plan.out;
  std::vector<std::string> inputs = {plan.look.scene_file.string()};
  for (const NamedRecording& named : named_recordings(options.files, options.recording))
    inputs.push_back(named.file);
  for (const std::string& input : inputs) {
    refuse_own_input(input, out.string());
    refuse_own_input(input, options.dots);
  }
  std::error_code unknown;
  if (!options.dots.empty() &&
      fs::weakly_canonical(options.dots, unknown) == fs::weakly_canonical(out, unknown))
    throw Error({options.dots}, "would be written twice", "name two files (--dots, -o)");
}

int render_file(const RenderOptions& options, const Console& console) {
  const RenderPlan plan = plan_of(options);
  refuse_lost_files(options, plan);
  print_warnings(plan.warnings, console);
  const scenes::Shot shot = shot_of(options, plan, console);
  if (!options.dots.empty() && shot.actors.front().dots.empty())
    throw Error("--dots: only point-light figures and markers have dots",
                "add --figure point-light or --figure markers");
  for (const scenes::Actor& actor : shot.actors)
    for (const std::string& warning : actor.warnings) console.err << "warning: " << warning << '\n';
  const std::string found = make_file(options, plan, shot, console);
  if (!options.dots.empty()) write_dots(shot, options.dots);
  console.out << fmt::format("{}: {} frames, {:.2f} s, {}\n", plan.out.string(), shot.frame_count(),
                             shot.frame_count() / plan.settings.output.fps, found);
  print_size(shot, plan.look, console);
  return exit_done;
}

/// The options of recordings, and that of all people of a file.
std::vector<CommandOption> recordings_to_render(RecordingArguments& recording) {
  std::vector<CommandOption> options = options_of_recordings(recording);
  for (CommandOption& option : options)
    if (option.names.front() == "--subject")
      option.help += "; all: everyone in the file, each in his recorded place";
  return options;
}

/// Options for input motions and the output file.
std::vector<CommandOption> file_options(RenderOptions& options) {
  return all_of(
      argument("files", &options.files,
               "Motion file: " + motion::formats_read() +
                   "; or two or three in one scene: target (green), created (blue), reference "
                   "(red)")
          .values(1, 3),
      recordings_to_render(options.recording),
      choice("--layout", options.layout,
             {{"superimposed", scenes::Layout::superimposed},
              {"side-by-side", scenes::Layout::side_by_side},
              {"as-recorded", scenes::Layout::as_recorded}},
             "How two or three motions are shown in one scene"),
      option(
          "-o,--output", &options.out,
          "Video (" + video_endings() +
              "), contact sheet (.png) or, with --still, still (.png, or .exr with all layers) to "
              "write; its folder is created if necessary (default: <file>.mp4 in the current "
              "folder)"),
      flag("--repeat", &options.repeat,
           "Animated images (webp, gif, apng): loop forever instead of playing once"));
}

/// Options for the look.
std::vector<CommandOption> look_options(LookOptions& look) {
  return {option("--camera", &look.camera,
                 "front, side, three-quarter, follow or orbit, or options: \"view: side\"")
              .with_default(),
          option("--figure", &look.figure,
                 motion::listed(scenes::figure_names<scenes::Figure>()) +
                     ", options (\"point-light: {scrambled: true}\"), or the file of a skinned "
                     "character (" +
                     fmt::format("{}", fmt::join(scenes::character_endings, ", ")) + ")")
              .with_default(),
          option("--face", &look.face,
                 "Of a character: neutral, hidden, weights (\"happy: 0.6\"), or a file of weights "
                 "(.csv, .glb)")
              .with_default("neutral"),
          option("--hands", &look.hands,
                 "Fingers: auto (where the motion has them), drawn (otherwise relaxed hands) or "
                 "hidden")
              .one_of({"auto", "drawn", "hidden"})
              .with_default(),
          option("--scene", &look.scene,
                 "studio, void, treadmill, corridor, lab-grid or a file (my.set.yaml; see mien "
                 "sets); default: studio, or void for point-light figures and markers")};
}

/// Options for stills, dots and noise.
std::vector<CommandOption> picture_options(RenderOptions& options) {
  return {
      option("--still", &options.still,
             "A still (.png or .exr) instead of a contact sheet, at that time in seconds (without "
             "a value: the middle, or the end of a trail)")
          .values(0, 1)
          .with_default("middle"),
      option("--dots", &options.dots,
             "Also write the positions of the dots of a point-light figure or of markers (CSV)"),
      option("--seed", &options.seed, "Random seed of point-light figures and markers")
          .with_default(),
      option(
          "--background", &options.background,
          "Background of a still: shown, transparent, or shadow (only the figure and its shadow)")
          .one_of({"shown", "transparent", "shadow"})
          .with_default(),
      option("--jobs,-j", &options.jobs, "Number of threads (default: one per processor)")
          .between(1, 1024)};
}

}  // namespace

Command render_command() {
  const auto options = std::make_shared<RenderOptions>();
  return {.name = "render",
          .summary = "Make a video of a motion file",
          .options = all_of(file_options(*options), options->output.options(),
                            look_options(options->look), picture_options(*options)),
          .notes =
              "Units, up axis, floor and camera are determined automatically.\n\n"
              "Examples:\n"
              "  mien render walk.bvh\n"
              "  mien render walk.bvh -o side.mp4 --camera side --size 1920x1080\n"
              "  mien render two-people.bvh --subject all\n"
              "  mien render walk.bvh -o teaser.png --figure \"trail: {traces: [feet, hands]}\"\n"
              "  mien render walk.bvh --figure \"point-light: {scrambled: true}\" --dots dots.csv\n"
              "  mien render walk.bvh -o slide.gif --repeat --size 480x270 --fps 15\n\n"
              "File extensions: .mp4 is H.264, .lossless.mp4 H.264 in lossless RGB, .webm VP9,\n"
              ".av1.webm AV1, .mkv FFV1 (lossless); .webp, .gif and .apng are animated images. "
              "Each file is decoded and\n"
              "compared with the rendered frames.",
          .run = [options](const Console& console) { return render_file(*options, console); }};
}

}  // namespace mien::pipeline
