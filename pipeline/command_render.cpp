#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <variant>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "motion/motion_file.h"
#include "pipeline/cli.h"
#include "pipeline/files.h"
#include "pipeline/film.h"
#include "pipeline/film_dots.h"
#include "pipeline/look_checks.h"
#include "pipeline/look_options.h"
#include "pipeline/output_checks.h"
#include "pipeline/progress.h"
#include "pipeline/recording_clip.h"
#include "pipeline/shot_files.h"
#include "scenes/shot.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

struct RenderOptions {
  std::vector<std::string> files;
  std::string out;
  std::string layout = "superimposed";
  std::string size = "960x540";
  double scale = 1.0;
  std::vector<int> crop;
  std::string quality = "standard";
  std::string background = "shown";
  double shutter = 0.0;
  LookOptions look;
  std::string dots;
  std::optional<double> still;  ///< seconds; negative: wherever the figure shows best
  std::uint64_t seed = 0;
  double fps = 30.0;
  int jobs = 0;
  bool repeat = false;
  bool in_place = false;
};

constexpr float superimposed_opacity = 0.75f;
constexpr double small_figure = 0.25;  // of the picture's height

/// A number within limits; CLI::Range lets "nan" pass.
CLI::Validator between(double least, double most) {
  return CLI::Validator(
      [=](const std::string& text) {
        double value = 0.0;
        if (CLI::detail::lexical_cast(text, value) && value >= least && value <= most) {
          return std::string();
        }
        return fmt::format("{} is not a number from {} to {}", text, least, most);
      },
      fmt::format("{} to {}", least, most));
}

std::optional<int> whole_number(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::array<int, 2> parse_size(const std::string& text) {
  const std::size_t times = text.find('x');
  const auto width = whole_number(std::string_view(text).substr(0, times));
  const auto height = times == std::string::npos
                          ? std::nullopt
                          : whole_number(std::string_view(text).substr(times + 1));
  const auto fits = [](std::optional<int> n) { return n && *n >= 16 && *n <= 8192; };
  if (fits(width) && fits(height)) return {*width, *height};
  throw Error("--size: \"" + text + "\" is no size of a video",
              "write <width>x<height>, each from 16 to 8192, for example 960x540");
}

std::optional<std::array<int, 4>> crop_of(const RenderOptions& options,
                                          const std::array<int, 2>& size) {
  if (options.crop.empty()) return std::nullopt;
  const auto& crop = options.crop;
  const auto within = [](int first, int length, int all) {
    return first >= 0 && length >= 1 && first <= all - length;
  };
  if (!within(crop[0], crop[2], size[0]) || !within(crop[1], crop[3], size[1])) {
    throw Error(
        fmt::format("--crop: is not within the picture of {} x {} pixels", size[0], size[1]),
        "write <from the left>,<from the top>,<width>,<height> in pixels of --size");
  }
  return std::array{crop[0], crop[1], crop[2], crop[3]};
}

FilmSettings settings_of(const RenderOptions& options) {
  FilmSettings settings;
  settings.output.size = parse_size(options.size);
  settings.output.scale = options.scale;
  settings.output.crop = crop_of(options, settings.output.size);
  settings.output.fps = options.fps;
  settings.output.frames = FrameFormat::none;
  settings.output.shutter = options.shutter;
  settings.loops = options.repeat;
  settings.output.quality = options.quality == "draft"   ? Quality::draft
                            : options.quality == "final" ? Quality::final
                                                         : Quality::standard;
  settings.threads = options.jobs > 0
                         ? options.jobs
                         : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  return settings;
}

bool is_picture(const fs::path& out) {
  return out.extension() == ".png" || out.extension() == ".exr";
}

std::string video_endings() {
  std::string endings;
  for (const render::VideoTraits& traits : render::video_kinds()) {
    endings += (endings.empty() ? "" : ", ") + std::string(traits.ending);
  }
  return endings;
}

fs::path output_of(const RenderOptions& options) {
  if (options.out.empty()) return fs::path(options.files.front()).stem().concat(".mp4");
  if (fs::path(options.out).extension() == ".exr" && !options.still) {
    throw Error("--output: only a still has layers", "add --still, or end it in .png");
  }
  if (is_picture(options.out) || render::video_kind_of(options.out)) return options.out;
  throw Error("--output: \"" + options.out + "\" is neither a video nor a picture",
              "end it in " + video_endings() + " (video) or .png (contact sheet)");
}

/// Sizes that the file asked for can have.
void check_size(const fs::path& out, const Output& output) {
  const auto [width, height] = output.shown_size();
  const auto [whole_width, whole_height] = output.whole_size();
  if (width < least_picture_side || height < least_picture_side) {
    throw Error(fmt::format("--size: leaves a picture of {} x {} pixels", width, height),
                fmt::format("leave at least {} each way", least_picture_side));
  }
  if (std::int64_t{whole_width} * whole_height > most_picture_pixels) {
    throw Error(
        fmt::format("--size: {} x {} pixels are too many to draw", whole_width, whole_height),
        "use a smaller --size or --scale");
  }
  for (const render::VideoKind kind : output.video) {
    const render::VideoTraits& traits = render::traits_of(kind);
    if (traits.even_size && (width % 2 != 0 || height % 2 != 0)) {
      throw Error(fmt::format("--size: {} needs an even width and height, and these are {} x {}",
                              traits.name, width, height),
                  "change --size, --scale or --crop until they are even");
    }
    if (output.fps > traits.most_fps) {
      throw Error(fmt::format("--fps: {} shows at most {} frames a second at their true speed",
                              out.filename().string(), traits.most_fps),
                  "use fewer, or another kind of video");
    }
  }
}

/// What a picture of that kind cannot show; the same as a manifest's output may not ask for.
void check_kind(const RenderOptions& options, const Look& look, const fs::path& out,
                bool is_still) {
  const bool is_layers = out.extension() == ".exr";
  const bool is_cut_out = options.background != "shown";
  if (options.still && !is_picture(out)) {
    throw Error("--still: a still is a picture", "end --output in .png, or in .exr for its layers");
  }
  if (is_cut_out && (!is_still || is_layers)) {
    throw Error("--background: only a still can be cut out", "add --still, and --output in .png");
  }
  if (options.shutter > 0.0 && (is_layers || is_cut_out)) {
    throw Error("--shutter: layers and cut-outs have no motion blur", "leave it out");
  }
  if (options.shutter > 0.0 && std::holds_alternative<scenes::PointLightOptions>(look.figure)) {
    throw Error("--shutter: point lights have no motion blur", "leave it out");
  }
  if (!look.camera.stereo_separation_m) return;
  if (is_layers || is_cut_out) {
    throw Error("--camera: layers and cut-outs are of one eye", "leave stereo out");
  }
  if (!options.crop.empty()) {
    throw Error("--crop: a stereo pair cannot be cropped", "leave --crop or stereo out");
  }
}

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

scenes::Layout layout_of(const RenderOptions& options) {
  return options.layout == "side-by-side" ? scenes::Layout::side_by_side
                                          : scenes::Layout::superimposed;
}

/// The name, or one made of it that is not taken yet; it is from now on.
std::string name_among(std::set<std::string>& names, const std::string& wanted) {
  std::string name = wanted;
  for (int number = 2; !names.insert(name).second; ++number) {
    name = fmt::format("{}-{}", wanted, number);
  }
  return name;
}

/// One motion in neutral colours, or a target, what was created after it, and a reference.
std::vector<scenes::Performance> performances_of(const RenderOptions& options) {
  constexpr std::array roles = {scenes::Role::target, scenes::Role::created,
                                scenes::Role::reference};
  const bool is_alone = options.files.size() == 1;
  const bool is_clear = is_alone || layout_of(options) == scenes::Layout::side_by_side;
  std::set<std::string> names;
  std::vector<scenes::Performance> performances;
  for (std::size_t i = 0; i < options.files.size(); ++i) {
    performances.push_back(
        {.name = name_among(names, fs::path(options.files[i]).stem().string()),
         .clip = motion::resampled(clip_of(motion::read_motion(options.files[i])), options.fps),
         .role = is_alone ? scenes::Role::neutral : roles[i],
         .opacity = is_clear ? 1.0f : superimposed_opacity});
  }
  return performances;
}

render::Background background_of(const RenderOptions& options) {
  return options.background == "shadow"        ? render::Background::shadow
         : options.background == "transparent" ? render::Background::transparent
                                               : render::Background::shown;
}

/// The frame of a still: a trail is whole at the end, other figures are in mid-motion in the
/// middle.
int still_frame(const scenes::Shot& shot, const RenderOptions& options) {
  const int last = shot.frame_count() - 1;
  const double seconds = options.still.value_or(-1.0);
  if (!std::isfinite(seconds))
    throw Error("--still: is no moment", "write seconds, for example 1.2");
  if (seconds < 0.0) return shot.actors.front().trail ? last : last / 2;
  return static_cast<int>(std::min<double>(std::round(seconds * options.fps), last));
}

/// How large the figure comes out, where that is worth a word.
void tell_size(const scenes::Shot& shot, const Look& look, const Console& console) {
  const render::Camera& camera = camera_at(shot, 0);
  const double pixels = scenes::figure_pixels(shot.cameras);
  if (look.camera.screen) {
    console.out << fmt::format("  standing figure: {:.1f} degrees of visual angle, {:.0f} pixels\n",
                               scenes::visual_degrees(shot.cameras), pixels);
  } else if (shot.cameras.cameras.size() == 1 && pixels < small_figure * camera.height &&
             shot.step.isZero() && !look.camera.figure_px && !look.camera.position) {
    console.err << fmt::format(
        "note: the figure is {:.0f} of {} pixels tall because its way has to "
        "be in the picture; --camera follow or --in-place show it larger\n",
        pixels, camera.height);
  }
}

void write_dots(const scenes::Shot& shot, const fs::path& file) {
  const DraftFile draft(file);
  write_file(draft.file(), dots_csv(shot));
  draft.publish();
}

int render_file(const RenderOptions& options, const Console& console) {
  FilmSettings settings = settings_of(options);
  const fs::path out = output_of(options);
  settings.output.video.clear();
  if (!is_picture(out)) settings.output.video = {*render::video_kind_of(out)};
  check_size(out, settings.output);
  const Look look = look_of(options.look);
  const scenes::Shot shot =
      scenes::stage(performances_of(options), {.set = set_of(look),
                                               .figure = look.figure,
                                               .camera = look.camera,
                                               .size = settings.output.whole_size(),
                                               .window = settings.output.window(),
                                               .pixel_scale = settings.output.scale,
                                               .in_place = options.in_place,
                                               .layout = layout_of(options),
                                               .seed = options.seed});
  const bool is_still =
      options.still.has_value() || (shot.actors.front().trail && out.extension() == ".png");
  check_kind(options, look, out, is_still);
  if (!options.dots.empty() && shot.actors.front().dots.empty()) {
    throw Error("--dots: only a point-light figure has dots", "add --figure point-light");
  }
  for (const scenes::Actor& actor : shot.actors) {
    for (const std::string& warning : actor.warnings) console.err << "warning: " << warning << '\n';
  }
  const TaskGraph graph = one_task(out.string());
  const DraftFile draft(out);
  std::string found;
  {
    Progress bar(console.err, console.err_is_terminal, graph, std::vector<TaskOutcome>(1),
                 steady_seconds);
    const RunObserver observer = bar.observer();
    const ShotWork work{shot, settings, console.stop,
                        [&](double share) { observer.progressed(graph.tasks[0], share); }};
    if (is_still) {
      const int frame = still_frame(shot, options);
      write_still(work, frame, background_of(options), draft.file());
      found = fmt::format("frame {}", frame);
    } else {
      found = (is_picture(out) ? write_contact_sheet : write_video)(work, draft.file());
    }
  }
  draft.publish();
  if (!options.dots.empty()) write_dots(shot, options.dots);
  console.out << out.string() << ": " << shot.frame_count() << " frames, "
              << fmt::format("{:.2f} s, {}\n", shot.frame_count() / options.fps, found);
  tell_size(shot, look, console);
  return exit_done;
}

}  // namespace

void add_render_command(CLI::App& app, Command& chosen) {
  CLI::App* command = app.add_subcommand("render", "Make a video of a motion file");
  const auto options = std::make_shared<RenderOptions>();
  command
      ->add_option(
          "files", options->files,
          "Motion file: BVH, AMC, glTF, GLB; or two or three in one scene: target (green), "
          "created (blue), reference (red)")
      ->required()
      ->expected(1, 3);
  command->add_option("--layout", options->layout, "Of several motions")
      ->check(CLI::IsMember({"superimposed", "side-by-side"}))
      ->capture_default_str();
  command->add_option("-o,--output", options->out,
                      "Video (" + video_endings() +
                          ") or contact sheet (.png); <file>.mp4 in this folder without it");
  command->add_flag("--repeat", options->repeat,
                    "Animated pictures (webp, gif, apng): repeat for ever instead of playing once");
  command->add_option("--size", options->size, "Width and height in pixels")->capture_default_str();
  command
      ->add_option("--scale", options->scale,
                   "Draw everything so many times as large: 0.5 for a quick look, 2 for print")
      ->check(between(0.05, 16.0))
      ->capture_default_str();
  command
      ->add_option("--crop", options->crop,
                   "Draw a part only: pixels from the left, from the top, width, height")
      ->delimiter(',')
      ->expected(4);
  command->add_option("--fps", options->fps, "Frames per second")
      ->check(between(1.0, 240.0))
      ->capture_default_str();
  command
      ->add_option("--camera", options->look.camera,
                   "front, side, three-quarter, follow or orbit, or options: \"view: side\"")
      ->capture_default_str();
  command
      ->add_option("--figure", options->look.figure,
                   "stick, mannequin, point-light or trail, options (\"point-light: {scrambled: "
                   "true}\"), or a character's file (.glb, .gltf, .vrm)")
      ->capture_default_str();
  command->add_option("--scene", options->look.scene,
                      "studio, void, treadmill, corridor, lab-grid or a file (my.set.yaml; see "
                      "mien sets); studio, or void for point lights, without it");
  command->add_flag("--in-place", options->in_place, "Walk on the spot instead of travelling");
  command
      ->add_option(
          "--still", options->still,
          "One picture (.png) instead of a contact sheet: of that moment in seconds, or of "
          "the middle (a trail's end) without a number")
      ->expected(0, 1)
      ->default_str("-1");
  command->add_option("--dots", options->dots, "Also write where the point lights are (CSV)");
  command->add_option("--seed", options->seed, "Of what is random about point lights")
      ->capture_default_str();
  command
      ->add_option("--shutter", options->shutter,
                   "Motion blur: degrees of 360 for which the shutter is open")
      ->check(between(0.0, 360.0))
      ->capture_default_str();
  command
      ->add_option("--background", options->background,
                   "Of a still: shown, transparent, or shadow (the figure and its shadow alone)")
      ->check(CLI::IsMember({"shown", "transparent", "shadow"}))
      ->capture_default_str();
  command->add_option("--quality", options->quality, "Samples per pixel")
      ->check(CLI::IsMember({"draft", "standard", "final"}))
      ->capture_default_str();
  command->add_option("--jobs,-j", options->jobs, "Threads (default: one a processor)")
      ->check(CLI::Range(1, 1024));
  command->footer(
      "\nUnits, up axis, ground and camera are found by themselves.\n\nExamples:\n"
      "  mien render walk.bvh\n  mien render walk.bvh -o side.mp4 --camera side --size 1920x1080\n"
      "  mien render walk.bvh -o teaser.png --figure \"trail: {traces: [feet, hands]}\"\n"
      "  mien render walk.bvh --figure \"point-light: {scrambled: true}\" --dots dots.csv\n"
      "  mien render walk.bvh -o slide.gif --repeat --size 480x270 --fps 15\n\n"
      "Endings: .mp4 is H.264, .lossless.mp4 H.264 in lossless RGB, .webm VP9, .av1.webm AV1, "
      ".mkv\n"
      "FFV1 (lossless); .webp, .gif and .apng are animated pictures. Each file is decoded again "
      "and\n"
      "held against the frames.");
  command->callback([&chosen, options] {
    chosen = [options](const Console& console) { return render_file(*options, console); };
  });
}

}  // namespace mien::pipeline
