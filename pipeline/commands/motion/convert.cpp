#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "motion/error.h"
#include "motion/fitting/recorded_points.h"
#include "motion/formats/written_motion.h"
#include "motion/points/point_axes.h"
#include "motion/rig/body_mapping.h"
#include "motion/rig/recording_clip.h"
#include "pipeline/commands/line/recording_options.h"
#include "pipeline/commands/motion/motion.h"

namespace mien::pipeline {

namespace {

struct ConvertOptions {
  std::string in;
  std::string out;
  RecordingArguments recording;
  bool body = false;
};

/// What was written, and in words what it is: "21 joints".
struct Conversion {
  std::vector<motion::ResultBytes> files;
  int frames = 0;
  std::string contents;
};

void warn(const ConvertOptions& options, const Console& console, const std::string& warning) {
  console.err << "warning: " << options.in << ": " << warning << '\n';
}

std::string count_of(int count, const char* what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

/// The points as they were recorded. Formats that must state the unit get the one in which a body
/// has human size if the file states none.
Conversion recorded(motion::PointRecording points, const ConvertOptions& options,
                    const Console& console) {
  for (const std::string& note : points.notes) warn(options, console, note);
  if (points.metres_per_unit == 0.0 && motion::written_format(options.out).states_unit) {
    const motion::PointAxes axes = motion::point_axes(points);
    points.metres_per_unit = axes.metres_per_unit;
    warn(options, console,
         fmt::format("The unit of its positions is not stated: by the size of the body, it is "
                     "taken to be {:.6g} m.",
                     axes.metres_per_unit));
  }
  return {motion::point_files(points, options.out), points.frame_count(),
          count_of(points.point_count(), "point") + ", as recorded"};
}

/// The body that is fitted to points.
motion::Recording fitted(const motion::PointRecording& points, const ConvertOptions& options,
                         const Console& console) {
  motion::RecordedPoints motion = motion::recorded_points(points);
  if (!motion.fit)
    throw Error(Place{options.in}, "its points cannot be fitted to a body: " + motion.rejection,
                "write the points themselves, as TRC (.trc) or as a table (.csv)");
  for (const std::string& note : motion.recording.notes) warn(options, console, note);
  return std::move(motion.recording);
}

/// In metres, unless the format keeps the unit of the input.
motion::Recording read_skeleton(motion::Recording recording, const ConvertOptions& options,
                                const Console& console) {
  for (const std::string& note : recording.notes) warn(options, console, note);
  const std::filesystem::path out = options.out;
  const motion::MotionFormat& format = motion::written_format(out);
  if (options.body || format.is_of_body) return motion::to_recording(motion::to_body(recording));
  if (!format.is_metric) return recording;
  const motion::RigAnalysis rig = motion::analyse_rig(recording);
  if (!rig.human)
    for (std::size_t i = recording.notes.size(); i < rig.warnings.size(); ++i)
      warn(options, console, rig.warnings[i]);
  return motion::in_metres(std::move(recording));
}

Conversion converted(motion::FileContents contents, const ConvertOptions& options,
                     const Console& console) {
  const std::filesystem::path out = options.out;
  const motion::MotionFormat& format = motion::written_format(out);
  auto* points = std::get_if<motion::PointRecording>(&contents);
  if (points != nullptr && format.holds_points() && !options.body)
    return recorded(std::move(*points), options, console);
  const motion::Recording recording =
      points != nullptr
          ? fitted(*points, options, console)
          : read_skeleton(std::get<motion::Recording>(std::move(contents)), options, console);
  std::string what = count_of(recording.skeleton.size(), "joint");
  if (points != nullptr)
    what += fmt::format(" of a body fitted to {}", count_of(points->point_count(), "point"));
  return {motion::motion_files(recording, options.out), recording.frame_count(), what};
}

int convert(const ConvertOptions& options, const Console& console) {
  const NamedRecording named = named_recording(options.in, options.recording);
  refuse_own_inputs({named.file, named.how.body_model}, options.out);
  const Conversion conversion =
      converted(motion::read_file(named.file, named.how), options, console);
  motion::write_results(conversion.files);
  console.out << options.out << ": " << conversion.frames << " frames, " << conversion.contents
              << '\n';
  for (std::size_t i = 1; i < conversion.files.size(); ++i)
    console.out << "  with " << conversion.files[i].target.string() << '\n';
  return exit_done;
}

}  // namespace

Command motion_convert_command() {
  const auto options = std::make_shared<ConvertOptions>();
  return {.name = "convert",
          .summary = "Convert a motion to another format",
          .options = all_of(
              argument("in", &options->in, "Motion file"),
              argument("out", &options->out,
                       "File to write: " + motion::formats_written() +
                           "; in metres with +Y up, except that BVH made from BVH or "
                           "AMC keeps their unit and axes"),
              recording_options(options->recording),
              flag("--body", &options->body,
                   "Map it onto the canonical body: 21 joints, and fingers if it has any; metres, "
                   "+Y up")),
          .notes =
              "Points (C3D, TRC, tables, keypoints …) stay the recorded points, in their own axes "
              "and with their\ngaps, when they are written as .trc, .csv, .npy or *_motion.tsv; "
              "for .bvh, .glb and .npz, or with\n--body, a body is fitted to them. Of skeletons, "
              "formats of points hold the positions of the joints.\n.npz is in the layout of "
              "AMASS: rotations of the canonical body, +Z up. Names, unit and frame rate of\n.csv "
              "and .npy are in a .json beside them; BIDS motion (*_motion.tsv) consists of three "
              "files.\n\nExamples:\n  mien motion convert walk.bvh walk.glb\n"
              "  mien motion convert 02_01.amc walk.bvh --body\n"
              "  mien motion convert trial.c3d trial.trc\n"
              "  mien motion convert trial.c3d sub-01_task-walk_tracksys-markers_motion.tsv",
          .run = [options](const Console& console) { return convert(*options, console); }};
}

}  // namespace mien::pipeline
