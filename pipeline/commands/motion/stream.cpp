#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "motion/formats/motion_file.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/commands/line/recording_options.h"
#include "pipeline/commands/motion/change.h"
#include "pipeline/commands/motion/live_stream.h"
#include "pipeline/commands/motion/motion.h"
#include "pipeline/production/synthesis/modified_motion.h"

namespace mien::pipeline {

namespace {

using nlohmann::ordered_json;

struct StreamOptions {
  std::string in;
  std::string change;
  std::string out;
  std::string recipes = "builtin@0.2";
  std::string subject;
  std::string calibration;
  std::string json;
  std::vector<std::string> leave_out;
  double delay_ms = -1.0;
  bool still_legs = false;
  bool lines = false;
  bool paced = false;
  bool measure = false;
};

void leave_out(motion::Modification& modification, const std::string& what) {
  const motion::Modification unchanged;
  if (what == "tempo") modification.tempo = unchanged.tempo;
  if (what == "stiffness") {
    modification.stiffness = unchanged.stiffness;
    modification.weight = unchanged.weight;
  }
  if (what == "variation") modification.variation = unchanged.variation;
  if (what == "relative") {
    modification.relative = unchanged.relative;
    modification.gesture = unchanged.gesture;
  }
  if (what == "acceleration") modification.acceleration = unchanged.acceleration;
  if (what == "paths") {
    modification.paths = unchanged.paths;
    modification.gains.reset();
  }
}

motion::Modification modification_of(const StreamOptions& options) {
  const Stimulus stimulus = stimulus_of({"", options.change, options.recipes});
  if (stimulus.modify.size() != 1 || stimulus.modify.front().style)
    throw Error(
        stimulus.modify.size() > 1 ? "several changes one after the other"
                                   : "a change based on examples",
        "a stream supports one change of paths, acceleration and posture; write it as one map");
  motion::Modification modification =
      motion::scaled(modifications_of(stimulus, {}).front(), stimulus.modify.front().strength);
  for (const std::string& what : options.leave_out) leave_out(modification, what);
  return modification;
}

/// The recording for the calibration: of several people the one who is streamed, if he is in it.
motion::Recording calibration_of(const StreamOptions& options) {
  NamedRecording named = named_recording(options.calibration);
  motion::Recording recording = motion::read_motion(named.file, named.how);
  if (std::ranges::find(recording.subjects, options.subject) == recording.subjects.end())
    return recording;
  named.how.subject = options.subject;
  return motion::read_motion(named.file, named.how);
}

LiveOptions live_options(const StreamOptions& options, const std::string& name) {
  LiveOptions live;
  live.name = name;
  live.modification = modification_of(options);
  live.measure = options.measure;
  if (options.still_legs) live.scope = motion::PathScope::upper_body;
  if (options.delay_ms >= 0.0) live.delay_ms = options.delay_ms;
  if (!options.calibration.empty()) live.calibration = calibration_of(options);
  return live;
}

ordered_json as_json(const motion::StreamError& error) {
  return {{"largest_metres", error.largest_metres},
          {"rms_metres", error.rms_metres},
          {"joint", std::string(motion::name_of(error.joint))},
          {"frame", error.frame}};
}

ordered_json as_json(const LiveReport& report) {
  const double milliseconds = 1000.0 / report.frames_per_second;
  ordered_json json = {
      {"frames", report.frames},
      {"frames_per_second", report.frames_per_second},
      {"delay",
       {{"frames", report.delay.frames()},
        {"milliseconds", report.delay.frames() * milliseconds},
        {"of_paths_frames", report.delay.paths},
        {"of_acceleration_frames", report.delay.timing},
        {"of_posture_frames", report.delay.posture}}},
      {"largest_limb_lag_milliseconds", report.largest_lag * milliseconds},
      {"computing_milliseconds",
       {{"mean", report.mean_computing_ms}, {"largest", report.most_computing_ms}}},
      {"warnings", report.warnings}};
  if (!report.measured) return json;
  const LiveMeasurement& measured = *report.measured;
  json["error"] = as_json(measured.error);
  json["error_of_paths_and_posture"] = as_json(measured.of_paths_and_posture);
  json["calibration_error"] = as_json(measured.calibration);
  json["feet"] = {{"plants", measured.plants},
                  {"largest_drift_metres", measured.drift_m},
                  {"largest_drift_of_source_metres", measured.drift_of_source_m}};
  return json;
}

std::string error_text(const motion::StreamError& error) {
  return fmt::format("maximum {:.1f} mm ({}, frame {}), RMS {:.1f} mm",
                     1000.0 * error.largest_metres, motion::name_of(error.joint), error.frame,
                     1000.0 * error.rms_metres);
}

void print_result(const LiveReport& report, const Console& console) {
  const double milliseconds = 1000.0 / report.frames_per_second;
  for (const std::string& warning : report.warnings) console.err << "warning: " << warning << '\n';
  console.err << fmt::format(
      "{} frames at {:g} per second; latency {} frames ({:.0f} ms); computing time per frame "
      "{:.2f} ms, at most {:.2f} ms\n",
      report.frames, report.frames_per_second, report.delay.frames(),
      report.delay.frames() * milliseconds, report.mean_computing_ms, report.most_computing_ms);
  if (report.largest_lag != 0.0)
    console.err << fmt::format("limbs up to {:.0f} ms {} the trunk\n",
                               std::abs(report.largest_lag) * milliseconds,
                               report.largest_lag > 0.0 ? "behind" : "before");
  if (!report.measured) return;
  const LiveMeasurement& measured = *report.measured;
  console.err << "error relative to modifying the whole motion: " << error_text(measured.error)
              << '\n'
              << "of paths and posture alone, without soft joint limits and acceleration: "
              << error_text(measured.of_paths_and_posture) << '\n'
              << "error of the calibration: " << error_text(measured.calibration) << '\n'
              << fmt::format(
                     "feet are not locked: planted feet slid by up to {:.0f} mm ({:.0f} mm before "
                     "the change) in {} contacts\n",
                     1000.0 * measured.drift_m, 1000.0 * measured.drift_of_source_m,
                     measured.plants);
}

/// Delays frames to the rate at which they were captured.
class Pace {
 public:
  explicit Pace(bool is_kept) : is_kept_(is_kept) {}

  void wait(double frames_per_second, const std::stop_token& stop) {
    if (!is_kept_) return;
    using namespace std::chrono;
    if (frames_ == 0) start_ = steady_clock::now();
    const auto due = start_ + duration_cast<steady_clock::duration>(duration<double>(
                                  static_cast<double>(frames_++) / frames_per_second));
    while (!stop.stop_requested() && steady_clock::now() < due)
      std::this_thread::sleep_for(
          std::min<steady_clock::duration>(due - steady_clock::now(), milliseconds(100)));
  }

 private:
  bool is_kept_;
  long frames_ = 0;
  std::chrono::steady_clock::time_point start_;
};

/// Processes all frames. Returns false if the reader has closed the pipe.
bool process_frames(MotionSource& source, LiveStream& live, const StreamOptions& options,
                    const std::stop_token& stop) {
  motion::BvhStream text(source.name(),
                         options.subject.empty() ? std::nullopt : std::optional(options.subject));
  Pace pace(options.paced);
  bool is_read = true;
  const auto pass = [&] {
    while (is_read && !stop.stop_requested()) {
      const std::optional<motion::Pose> pose = text.next();
      if (!pose) return;
      pace.wait(text.head()->frames_per_second, stop);
      is_read = live.take(*text.head(), *pose);
    }
  };
  while (is_read) {
    const std::optional<std::string> piece = source.next(stop);
    if (!piece) break;
    text.push(*piece);
    pass();
  }
  if (!is_read || stop.stop_requested()) return is_read;
  text.finish();
  pass();
  return is_read;
}

int stream_motion(const StreamOptions& options, const Console& console) {
  refuse_own_input(options.in, options.out);
  refuse_own_input(options.in, options.json);
  MotionSource source(options.in);
  MotionSink sink(console.out, options.out,
                  options.lines ? MotionSink::Form::lines : MotionSink::Form::bvh);
  LiveStream live(live_options(options, source.name()), sink);
  const bool is_read = process_frames(source, live, options, console.stop);
  if (console.stop.stop_requested() && !live.has_begun()) return exit_interrupted;
  const LiveReport report = live.finish();
  sink.publish();
  if (!is_read) console.err << "the reader closed the stream\n";
  print_result(report, console);
  if (!options.json.empty()) write_file(options.json, as_json(report).dump(2) + "\n");
  return console.stop.stop_requested() ? exit_interrupted : exit_done;
}

}  // namespace

Command motion_stream_command() {
  const auto options = std::make_shared<StreamOptions>();
  return {
      .name = "stream",
      .summary = "Change the emotional content of a motion during capture",
      .options =
          {argument("in", &options->in, "BVH file or pipe, - for standard input"),
           argument("change", &options->change,
                    "An emotion, or the value of `modify:` in a manifest"),
           option("-o,--out", &options->out, "BVH file to write (default: standard output)"),
           flag("--lines", &options->lines, "Write frame lines only, without the hierarchy"),
           option("--delay", &options->delay_ms,
                  "Latency in milliseconds (default: if the change has paths, the shortest at "
                  "which the built-in motions stay within 1 cm of the result of mien motion "
                  "modify without foot locking; otherwise 0)")
               .between(0.0, 10000.0),
           option("--leave-out", &options->leave_out,
                  "Parts of the change to leave out: tempo, variation, acceleration, paths, "
                  "stiffness (with weight), relative (range, step_width, step_length, sway, "
                  "arm_swing, trunk_swing, gesture)")
               .one_of({"tempo", "variation", "acceleration", "paths", "stiffness", "relative"}),
           flag("--still-legs", &options->still_legs,
                "Change the amplitude of movement (paths) of trunk, head and arms only, so that "
                "feet do not slide"),
           option("--subject", &options->subject,
                  "Name or number of the person to use, if the BVH file has several"),
           option("--calibration", &options->calibration,
                  "A recording of the same rig (FILE or FILE#TAKE) from which its proportions and "
                  "floor are measured"),
           option("--recipes", &options->recipes,
                  "builtin@0.2 (those of mien 0.2, which can be streamed), builtin@0.3, builtin, "
                  "fig29 (after "
                  "figure 29 of a thesis on emotion in motion capture), or a file of recipes")
               .with_default(),
           flag("--measure", &options->measure,
                "Keep all frames, and report at the end how far they deviate from those of mien "
                "motion modify"),
           flag("--paced", &options->paced, "Read frames no faster than they were captured"),
           option("--json", &options->json, "File for latency and measurements, as JSON")},
      .notes =
          "Frames are written as soon as they are available; a summary goes to standard error. "
          "Planted feet are\n"
          "not locked, and tempo, variation, stiffness, weight and changes in the actor's own "
          "terms cannot be\nstreamed.\n\nExamples:\n"
          "  capture | mien motion stream - 'emotion: sad' --leave-out tempo > sad.bvh\n"
          "  mien motion stream walk.bvh 'posture: {head-flexion: 20}' --paced | viewer\n"
          "  mien motion stream walk.bvh 'paths: 1.6' --measure -o longer.bvh",
      .run = [options](const Console& console) { return stream_motion(*options, console); }};
}

}  // namespace mien::pipeline
