#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include "motion/formats/motion_file.h"
#include "motion/rig/body_mapping.h"
#include "motion/rig/recording_clip.h"
#include "pipeline/commands/line/take_option.h"
#include "pipeline/commands/motion/motion.h"

namespace mien::pipeline {

namespace {

struct ConvertOptions {
  std::string in;
  std::string out;
  RecordingArguments recording;
  bool body = false;
};

int convert(const ConvertOptions& options, const Console& console) {
  refuse_own_input(options.in, options.out);
  motion::Recording recording = read_with_warnings(options.in, options.recording, console);
  const motion::MotionFormat* format = motion::motion_format(options.out);
  if (options.body) {
    recording = motion::to_recording(motion::to_body(recording));
  } else if (format != nullptr && format->is_metric) {
    const motion::RigAnalysis rig = motion::analyse_rig(recording);
    if (!rig.human)
      for (std::size_t i = recording.notes.size(); i < rig.warnings.size(); ++i)
        console.err << "warning: " << options.in << ": " << rig.warnings[i] << '\n';
    recording = motion::in_metres(std::move(recording));
  }
  motion::write_motion(recording, options.out);
  console.out << options.out << ": " << recording.frame_count() << " frames, "
              << recording.skeleton.size() << " joints\n";
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
                           "; glTF in metres with +Y up, others in the unit and axes of the input"),
              recording_options(options->recording),
              flag("--body", &options->body,
                   "Map it onto the canonical body: 21 joints, metres, +Y up")),
          .notes =
              "Examples:\n  mien motion convert walk.bvh walk.glb\n"
              "  mien motion convert 02_01.amc walk.bvh --body",
          .run = [options](const Console& console) { return convert(*options, console); }};
}

}  // namespace mien::pipeline
