#include "pipeline/cli.h"

#include <exception>
#include <memory>

#include <CLI/CLI.hpp>

#include "motion/error.h"
#include "pipeline/task_graph.h"

namespace mien::pipeline {

namespace {

constexpr char description[] =
    "mien makes human motion stimuli: from adjectives to walks, videos and comparison sheets.";

constexpr char examples[] = R"(
Examples:
  mien check manifests/quickstart.yaml     what is wrong with a manifest, if anything
  mien run manifests/quickstart.yaml       make everything it asks for
  mien render walk.bvh                     a video of any motion file
  mien motion info walk.bvh                what is in a motion file

Exit codes: 0 done, 1 failed, 2 bad input, 130 interrupted.
Progress and faults go to standard error, results to standard output.)";

int parse(CLI::App& app, int argc, const char* const* argv, const Console& console) {
  if (argc <= 1) {
    console.err << app.help();
    return exit_bad_input;
  }
  try {
    app.parse(argc, argv);
    return exit_done;
  } catch (const CLI::ParseError& error) {
    return app.exit(error, console.out, console.err) == exit_done ? exit_done : exit_bad_input;
  }
}

int perform(const Command& command, const Console& console) {
  try {
    return command(console);
  } catch (const Interrupted&) {
    console.err << "interrupted\n";
    return exit_interrupted;
  } catch (const Error& error) {
    console.err << error.what() << '\n';
    return exit_bad_input;
  } catch (const std::exception& error) {
    console.err << "mien: " << error.what() << '\n';
    return exit_failed;
  }
}

}  // namespace

int run_command_line(int argc, const char* const* argv, const Console& console) {
  CLI::App app(description, "mien");
  app.footer(examples);
  app.require_subcommand(1);
  Command chosen;
  add_run_command(app, chosen);
  add_check_command(app, chosen);
  add_plan_command(app, chosen);
  add_render_command(app, chosen);
  add_motion_command(app, chosen);
  add_study_command(app, chosen);
  add_version_command(app, chosen);
  if (const int code = parse(app, argc, argv, console); code != exit_done || !chosen) return code;
  return perform(chosen, console);
}

}  // namespace mien::pipeline
