#include "pipeline/commands/regress/regress.h"

#include <filesystem>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "motion/error.h"
#include "motion/formats/motion_file.h"
#include "motion/math/geometry.h"
#include "pipeline/base/documents/failure_text.h"
#include "pipeline/commands/regress/regress_study.h"
#include "pipeline/commands/take_option.h"
#include "pipeline/regression/comparison/compared_media.h"
#include "pipeline/tasks/task_graph.h"

namespace mien::pipeline {

namespace {

constexpr char study_group[] = "Of a study";
constexpr char files_group[] = "How much is no difference between two files";

/// What is of no use there must not seem to be of use.
void refuse_options(const CLI::App& command, const std::string& group, const std::string& remedy) {
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_group() == group && option->count() > 0)
      throw Error({option->get_name()},
                  group == study_group ? "is for studies, not for two files"
                                       : "is for two files, not for a study",
                  remedy);
  }
}

/// 1 means that something differs: whatever keeps it from being known is 2.
int compared(const Command& comparison, const Console& console) {
  try {
    return comparison(console);
  } catch (const Interrupted&) {
    throw;
  } catch (const Error&) {
    throw;
  } catch (const std::exception& error) {
    console.err << "mien: could not be compared: " << failure_text(error) << '\n';
    return exit_bad_input;
  }
}

void require_file(const std::string& file) {
  if (std::filesystem::is_directory(file) && !is_media(file))
    throw Error({file}, "is a folder that holds no pictures",
                "name a folder of pictures (PNG, EXR, JPEG, TIFF), or a file");
  if (std::filesystem::exists(file)) return;
  throw Error({file}, "no such file",
              "name two motion files, pictures, videos or folders of pictures: what was, and what "
              "is now");
}

int regress_files(const RegressOptions& options, const Console& console) {
  const auto both = [&](const auto& is_kind) {
    return is_kind(options.before) && is_kind(options.now);
  };
  require_file(options.before);
  require_file(options.now);
  if (both([](const std::string& file) { return motion::is_motion_file(file); }))
    return regress_motion_files(options, console);
  if (both([](const std::string& file) { return is_media(file); })) {
    if (!options.takes.empty())
      throw Error({"--take"}, "is for motions, not for pictures and videos", "leave it out");
    return regress_media_files(options, console);
  }
  throw Error({options.now}, "cannot be compared with " + options.before,
              "motion files can (BVH, Acclaim, glTF), and pictures (PNG, EXR, JPEG, TIFF), folders "
              "of them and videos");
}

/// A motion, picture or video alone is no study.
void refuse_lone_file(const std::string& file) {
  if (!motion::is_motion_file(file) && !is_media(file)) return;
  throw Error({file}, "is compared with nothing: a second file is missing",
              "name what is now after what was: mien regress approved.bvh walk.bvh");
}

/// Somebody will want to know in a year.
std::string refuse_blank(const std::string& text) {
  const bool is_blank = text.find_first_not_of(" \t\r\n") == std::string::npos;
  return is_blank ? "say in a sentence why it may look as it does now" : "";
}

CLI::Option* add_tolerance(CLI::App& command, const std::string& flag, double& value,
                           const std::string& help) {
  return command.add_option(flag, value, help)
      ->check(CLI::Range(0.0, 1000.0))
      ->capture_default_str()
      ->group(files_group);
}

/// In degrees on the command line, in radians inside.
void add_rotation_tolerance(CLI::App& command, motion::MotionTolerance& tolerance) {
  command
      .add_option_function<double>(
          "--rotation",
          [&tolerance](double degrees) {
            tolerance.rotation_radians = degrees * motion::radians_per_degree;
          },
          "Degrees that a joint may turn otherwise on its parent")
      ->check(CLI::Range(0.0, 180.0))
      ->default_str("0.1")
      ->group(files_group);
}

void add_tolerances(CLI::App& command, motion::MotionTolerance& tolerance) {
  add_tolerance(command, "--position", tolerance.position_m,
                "Metres that a joint, or a point 10 cm off its bone, may be elsewhere");
  add_rotation_tolerance(command, tolerance);
  add_tolerance(command, "--velocity", tolerance.velocity_m_s,
                "Metres a second that a joint may be quicker, slower or go elsewhere");
  add_tolerance(command, "--contacts", tolerance.contact_seconds,
                "Seconds that a foot may come down or leave earlier or later");
  add_tolerance(command, "--slide", tolerance.slide_m,
                "Metres that a foot may slide where it stood");
  add_tolerance(command, "--duration", tolerance.duration_seconds,
                "Seconds that one may last longer");
  command.add_flag("--any-rate", tolerance.any_rate, "Another frame rate is no difference")
      ->group(files_group);
  command
      .add_flag("--any-lint", tolerance.any_lint,
                "New faults that mien motion lint calls errors are no difference")
      ->group(files_group);
}

constexpr char footer[] =
    "\nMotions are compared as they are: nothing is settled on the floor, aligned or turned first. "
    "Joints are paired by name; where rigs differ, both are put on one body. Told are the largest "
    "change in a sentence (which joint does something else itself, not which ones it carries "
    "along; "
    "a shift by frames, exchanged sides, another path), distances with and without alignment, "
    "velocities, foot contacts, faults that came or went, and motion features.\n\n"
    "Of a study, how much is no difference stands in its manifest (regression:).\n\n"
    "Identical motions always pass. Exit code: 0 when they are alike, 1 when they differ, 2 when "
    "that could not be found out: bad input, a damaged baseline, no room for the report.\n\n"
    "Examples:\n"
    "  mien regress study.yaml --only sad-walk,happy-walk\n"
    "  mien regress approved/walk.bvh walk.bvh\n"
    "  mien regress approved/walk.bvh walk.glb --position 0.005 --rotation 0.5 --json";

constexpr char approve_footer[] =
    "\nA baseline holds what is needed to tell later what has changed, and why: the manifest and "
    "what it names, motions, a few key frames, hashes; with --keep-videos the videos themselves. "
    "It "
    "is made to lie in git. Look at the study before you approve it.\n\n"
    "Examples:\n"
    "  mien regress approve study.yaml --why \"first version\"\n"
    "  mien regress approve study.yaml --only sad-walk --why \"arms swing less, as asked\"";

void add_study_options(CLI::App& command, StudyArguments& arguments, const char* baseline) {
  command
      .add_option("--baseline", arguments.baseline,
                  std::string(baseline) + " (default: baselines/<study> beside the manifest)")
      ->group(study_group);
  command.add_option("--out", arguments.production.out, "Folder in which studies are made")
      ->capture_default_str()
      ->group(study_group);
  command.add_option("--jobs,-j", arguments.production.jobs, "Threads (default: one a processor)")
      ->check(CLI::Range(1, 1024))
      ->group(study_group);
  command
      .add_flag("--without-videos", arguments.without_videos,
                "Make and compare motions and key frames alone")
      ->group(study_group);
}

void add_approve_command(CLI::App& regress, Command& chosen) {
  CLI::App* command = regress.add_subcommand("approve", "Store a study as it should look");
  const auto arguments = std::make_shared<StudyArguments>();
  command->add_option("manifest", arguments->production.manifest, "Manifest (YAML) of the study")
      ->required();
  command->add_option("--why", arguments->why, "Why it may look as it does now")
      ->required()
      ->check(refuse_blank);
  command->add_option("--who", arguments->who, "Who says so (default: git's user.name)");
  command
      ->add_option("--only", arguments->production.only,
                   "Approve these stimuli; the others stay as they were approved")
      ->delimiter(',');
  command->add_option("--key-frames", arguments->key_frames, "Frames that are kept of a stimulus")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str();
  command->add_flag("--keep-videos", arguments->keep_videos,
                    "Keep the videos too, for reports to show them beside those of then; the "
                    "baseline grows by their size");
  add_study_options(*command, *arguments, "Folder of the baseline, new or one of the study");
  command->footer(approve_footer);
  command->callback([&chosen, arguments] {
    chosen = [arguments](const Console& console) { return approve_study(*arguments, console); };
  });
}

}  // namespace

void add_regress_command(CLI::App& app, Command& chosen) {
  CLI::App* command = app.add_subcommand(
      "regress", "Tell whether a study or a motion is what it was, and what changed if not");
  command->require_subcommand(0, 1);
  const auto options = std::make_shared<RegressOptions>();
  const auto study = std::make_shared<StudyArguments>();
  command->add_option(
      "before", options->before,
      "Manifest of a study; or a motion, picture, video or folder of pictures as it was");
  command->add_option("now", options->now, "The same as it is now");
  add_study_options(*command, *study, "Folder of the baseline, or a branch, tag or commit of git");
  command
      ->add_option("--report,-o", study->report,
                   "Folder of the report (default: "
                   "<out>/<study>-regression)")
      ->group(study_group);
  command
      ->add_option("--only", study->production.only,
                   "Make and compare these stimuli alone; nothing is told about the others")
      ->delimiter(',')
      ->group(study_group);
  command
      ->add_option("--repeat", study->repeat,
                   "Make motions and key frames so many times, and tell what differs")
      ->check(CLI::Range(1, 100))
      ->group(study_group);
  command
      ->add_option("--audits", study->audits,
                   "Share of the stimuli that are drawn although nothing about them has changed")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str()
      ->group(study_group);
  add_takes_option(*command, options->takes);
  add_tolerances(*command, options->tolerance);
  command
      ->add_option("--perceptual", options->perceptual,
                   "Mean FLIP, 0 to 1, that a picture or frame of a video may have")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str()
      ->group(files_group);
  command->add_flag("--json", options->json, "Everything that is known, as JSON");
  command->footer(footer);
  add_approve_command(*command, chosen);
  command->callback([command, &chosen, options, study] {
    if (!command->get_subcommands().empty()) return;
    if (options->before.empty()) throw CLI::RequiredError("before");
    if (options->now.empty()) {
      study->production.manifest = options->before;
      study->production.json = options->json;
      chosen = [command, options, study](const Console& console) {
        refuse_lone_file(study->production.manifest);
        if (!options->takes.empty())
          throw Error({"--take"}, "is for two motion files, not for a study",
                      "set take: in the manifest");
        refuse_options(*command, files_group, "set regression: in the manifest");
        return compared([&](const Console& where) { return regress_study(*study, where); },
                        console);
      };
    } else {
      chosen = [command, options](const Console& console) {
        refuse_options(*command, study_group, "leave it out");
        return compared([&](const Console& where) { return regress_files(*options, where); },
                        console);
      };
    }
  });
}

}  // namespace mien::pipeline
