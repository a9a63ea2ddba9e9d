#include "pipeline/commands/cli.h"

namespace mien::pipeline {

namespace {

constexpr char examples[] = R"(Examples:
  mien run quickstart                      make everything that a manifest asks for
  mien manifests quickstart > my.yaml      the same manifest, to begin your own with
  mien check my.yaml                       what is wrong with a manifest, if anything
  mien render walk.bvh                     a video of any motion file
  mien motion info walk.bvh                what is in a motion file
)";

/// "Exit codes: 0 done, …"
std::string told_exit_codes() {
  std::string text;
  for (const ExitCode& exit : exit_codes) {
    text += (text.empty() ? "Exit codes: " : ", ") + std::to_string(exit.code) + " " + exit.meaning;
  }
  return text + ".\n";
}

}  // namespace

Command mien_program() {
  return {.name = "mien",
          .summary =
              "mien makes human motion stimuli: from adjectives to walks, videos and comparison "
              "sheets.",
          .options = {flag("--version", {}, "Display program version information and exit")},
          .commands = {run_command(), check_command(), plan_command(), verify_command(),
                       regress_command(), clean_command(), pack_command(), render_command(),
                       motion_command(), manifests_command(), sets_command(), studio_command(),
                       study_command(), farm_command(), version_command(), completion_command(),
                       man_command()},
          .notes = examples + ("\n" + told_exit_codes()) +
                   "Progress and faults go to standard error, results to standard output."};
}

}  // namespace mien::pipeline
