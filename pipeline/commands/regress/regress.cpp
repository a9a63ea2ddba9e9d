#include "pipeline/commands/regress/regress.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "motion/error.h"
#include "motion/formats/motion_file.h"
#include "motion/math/geometry.h"
#include "motion/measures/differences/motion_tolerance.h"
#include "pipeline/base/documents/fault.h"
#include "pipeline/commands/line/examples_option.h"
#include "pipeline/commands/line/external_programs.h"
#include "pipeline/commands/line/recording_options.h"
#include "pipeline/commands/regress/regress_study.h"
#include "pipeline/regression/comparison/compared_media.h"
#include "pipeline/regression/comparison/compared_motions.h"
#include "pipeline/tasks/task_graph.h"

namespace mien::pipeline {

namespace {

/// Options of `mien regress`.
struct RegressOptions {
  std::string before;            ///< what was approved
  std::string now;               ///< what is to be judged
  RecordingArguments recording;  ///< of motion files
  motion::MotionTolerance tolerance;
  double rotation_degrees = 0.1;  ///< of the tolerance, as it is typed
  double perceptual = 0.0;        ///< mean ꟻLIP that pictures may have
  bool json = false;
  std::vector<std::string> given;  ///< options that are of files alone
};

constexpr char study_group[] = "Options for a study";
constexpr char files_group[] = "Tolerances for two files";

/// Refuses options that have no effect.
void refuse_options(const std::vector<std::string>& given, const char* wrong, const char* remedy) {
  if (!given.empty()) throw Error({given.front()}, wrong, remedy);
}

/// Runs a comparison. Exit code 1 is reserved for differences, so any failure gives 2.
int compared(const std::function<int()>& comparison, const Console& console) {
  try {
    return comparison();
  } catch (const Interrupted&) {
    throw;
  } catch (const Error&) {
    throw;
  } catch (const std::exception& error) {
    console.err << "mien: comparison failed: " << failure_text(error) << '\n';
    return exit_bad_input;
  }
}

void require_file(const std::string& file) {
  if (std::filesystem::is_directory(file) && !is_media(file))
    throw Error({file}, "is a folder without images",
                "name a folder of images (PNG, EXR, JPEG, TIFF), or a file");
  if (std::filesystem::exists(file)) return;
  throw Error({file}, "no such file",
              "name two motion files, images, videos or folders of images: the approved one, then "
              "the current one");
}

/// Prints how two files differ to `console.out` and returns the exit code.
template <class Compared>
int print_comparison(const Compared& files, const RegressOptions& options, const Console& console) {
  if (options.json) {
    const auto replace = nlohmann::ordered_json::error_handler_t::replace;
    console.out << as_json(files).dump(2, ' ', false, replace) << '\n';
  } else {
    console.out << as_text(files);
  }
  return files.are_alike() ? exit_done : exit_failed;
}

int regress_files(const RegressOptions& options, const Console& console) {
  const auto both = [&](const auto& is_kind) {
    return is_kind(options.before) && is_kind(options.now);
  };
  const std::vector<NamedRecording> named =
      named_recordings({options.before, options.now}, options.recording);
  require_file(named[0].file);
  require_file(named[1].file);
  if (motion::is_motion_file(named[0].file) && motion::is_motion_file(named[1].file)) {
    return print_comparison(compared_motion_files(named[0].file, named[1].file, options.tolerance,
                                                  {named[0].how, named[1].how}),
                            options, console);
  }
  if (both([](const std::string& file) { return is_media(file); })) {
    refuse_recording_options(options.recording, "images and videos", "omit them");
    return print_comparison(compared_media(options.before, options.now, options.perceptual),
                            options, console);
  }
  throw Error({options.now}, "cannot be compared with " + options.before,
              "name two motions: " + motion::formats_read() +
                  "; two images: PNG, EXR, JPEG, TIFF, or folders of them; or two videos");
}

/// Refuses a motion, image or video in place of a study.
void refuse_lone_file(const std::string& file) {
  if (!motion::is_found_as_motion(file) && !is_media(file)) return;
  throw Error({file}, "a second file to compare with is missing",
              "name the approved file, then the current one: mien regress approved.bvh walk.bvh");
}

int regress(RegressOptions options, StudyArguments study, const Console& console) {
  if (options.before.empty())
    throw Error("mien regress: nothing to compare was given", "see mien regress --help");
  if (!options.now.empty()) {
    refuse_options(study.given, "applies to studies, not to two files", "omit it");
    options.tolerance.rotation_radians = options.rotation_degrees * motion::radians_per_degree;
    return regress_files(options, console);
  }
  refuse_lone_file(options.before);
  refuse_recording_options(options.recording, "a study",
                           "set take:, subject:, fps: and joints: in the manifest");
  refuse_options(options.given, "applies to two files, not to a study",
                 "set regression: in the manifest");
  study.production.manifest = options.before;
  study.production.json = options.json;
  return regress_study(study, console);
}

/// The option --reason: the reason of an approval, stored with it.
CommandOption reason_option(std::string& reason) {
  CommandOption made = option("--reason", &reason, "Reason for approving the present state")
                           .required()
                           .formerly("--why");
  made.fault = [](const std::string& text) -> std::string {
    const bool is_blank = text.find_first_not_of(" \t\r\n") == std::string::npos;
    return is_blank ? "give the reason for approving in one sentence" : "";
  };
  return made;
}

/// Options under one heading; names of those used are added to `given`.
std::vector<CommandOption> in_group(const char* heading, std::vector<std::string>& given,
                                    std::vector<CommandOption> options) {
  for (CommandOption& option : options) {
    option.group = heading;
    option.given = &given;
  }
  return options;
}

CommandOption tolerance(const std::string& name, double& value, const std::string& help) {
  return option(name, &value, help).between(0.0, 1000.0).with_default();
}

std::vector<CommandOption> file_options(RegressOptions& options) {
  motion::MotionTolerance& allowed = options.tolerance;
  return {
      tolerance("--position", allowed.position_m,
                "Tolerated displacement of a joint, or of a point 10 cm off its bone, in metres"),
      option("--rotation", &options.rotation_degrees,
             "Tolerated difference of a joint's rotation relative to its parent, in degrees")
          .between(0.0, 180.0)
          .with_default(),
      tolerance("--velocity", allowed.velocity_m_s,
                "Tolerated velocity difference of a joint, or of a point 10 cm off its bone, in "
                "metres per second"),
      tolerance("--contacts", allowed.contact_seconds,
                "Tolerated shift of a foot contact, in seconds"),
      tolerance("--slide", allowed.slide_m,
                "Tolerated additional sliding of a planted foot, in metres"),
      tolerance("--duration", allowed.duration_seconds,
                "Tolerated difference of duration, in seconds"),
      flag("--any-rate", &allowed.any_rate, "Accept another frame rate"),
      flag("--any-lint", &allowed.any_lint,
           "Accept new faults that mien motion lint classifies as errors"),
      option("--perceptual", &options.perceptual,
             "Tolerated mean FLIP of an image or video frame, 0 to 1")
          .between(0.0, 1.0)
          .with_default()};
}

constexpr char footer[] =
    "Motions are compared as they are, without foot locking, alignment or rotation. If the rigs "
    "differ, both motions are retargeted to one body; if only the names of joints differ, this is "
    "reported as the difference. The report gives the largest change in a sentence, which names "
    "the joint that causes the change, not those that move with it, and recognizes time shifts, "
    "left and right swapped, and a displaced figure. It also gives distances with and without "
    "alignment, velocities, foot contacts, faults that appeared or disappeared, and motion "
    "features.\n\n"
    "The tolerances of a study are in its manifest (regression:).\n\n"
    "Exit code: 0 no difference beyond tolerance, 1 differences, 2 "
    "comparison failed (bad input, a damaged baseline, no space for the report).\n\n"
    "Examples:\n"
    "  mien regress study.yaml --only sad-walk,happy-walk\n"
    "  mien regress approved/walk.bvh walk.bvh\n"
    "  mien regress approved/walk.bvh walk.glb --position 0.005 --rotation 0.5 --json";

constexpr char approve_footer[] =
    "A baseline holds what is needed to detect and explain later changes: the manifest and the "
    "files it names, motions, a few key frames, and hashes; with --keep-videos also the videos. It "
    "is meant to be kept in git. Look at the study before approving it.\n\n"
    "Examples:\n"
    "  mien regress approve study.yaml --reason \"first version\"\n"
    "  mien regress approve study.yaml --only sad-walk --reason \"arms swing less, as asked\"";

std::vector<CommandOption> study_options(StudyArguments& arguments, const char* baseline,
                                         const char* without_videos) {
  return {option("--baseline", &arguments.baseline,
                 std::string(baseline) + " (default: baselines/<study> beside the manifest)"),
          option("--out", &arguments.production.out, "Folder of all studies").with_default(),
          option("--jobs,-j", &arguments.production.jobs,
                 "Number of threads (default: one per processor)")
              .between(1, 1024),
          flag("--without-videos", &arguments.without_videos, without_videos)};
}

Command approve_command() {
  const auto arguments = std::make_shared<StudyArguments>();
  return {
      .name = "approve",
      .summary = "Approve the present state of a study and store it as a baseline",
      .options = all_of(
          argument("manifest", &arguments->production.manifest, "Manifest (YAML) of the study"),
          reason_option(arguments->reason),
          option("--approver", &arguments->approver, "Who approves (default: git's user.name)")
              .formerly("--who"),
          option("--only", &arguments->production.only,
                 "Approve these stimuli only; the others keep their approved state")
              .with_commas(),
          option("--key-frames", &arguments->key_frames, "Number of key frames kept per stimulus")
              .between(1, 10000)
              .with_default(),
          flag("--keep-videos", &arguments->keep_videos,
               "Keep the videos as well, so that reports show them side by side; the baseline "
               "grows by their size"),
          in_group(study_group, arguments->given,
                   study_options(*arguments,
                                 "Folder of the baseline, new or an existing one of the study",
                                 "Approve motions and key frames only; videos are then not "
                                 "compared either"))),
      .notes = approve_footer,
      .run = [arguments](const Console& console) { return approve_study(*arguments, console); }};
}

}  // namespace

Command regress_command() {
  const auto options = std::make_shared<RegressOptions>();
  const auto study = std::make_shared<StudyArguments>();
  return {
      .name = regress_program.command,
      .summary = regress_program.summary,
      .options = all_of(
          argument("before", &options->before,
                   "Manifest of a study; or the approved motion, image, video or folder of images")
              .optional(),
          argument("now", &options->now, "The current version of the same").optional(),
          in_group(
              study_group, study->given,
              all_of(
                  study_options(*study, "Folder of the baseline, or a branch, tag or commit of git",
                                "Make and compare motions and key frames only"),
                  option("--report,-o", &study->report,
                         "Folder of the report (default: <out>/<study>-regression)"),
                  option("--only", &study->production.only, "Make and compare these stimuli only")
                      .with_commas(),
                  option(
                      "--repeat", &study->repeat,
                      "Number of times that motions and key frames are made; differences between "
                      "repetitions are reported")
                      .between(1, 100),
                  option(
                      "--audits", &study->audits,
                      "Proportion of unchanged stimuli that are nevertheless rendered and compared")
                      .between(0.0, 1.0)
                      .with_default())),
          options_of_recordings(options->recording),
          in_group(files_group, options->given, file_options(*options)),
          flag("--json", &options->json, "Complete result as JSON")),
      .commands = {approve_command()},
      .notes = footer,
      .run = [options, study](const Console& console) {
        return compared([&] { return regress(*options, *study, console); }, console);
      }};
}

}  // namespace mien::pipeline
