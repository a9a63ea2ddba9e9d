#include "pipeline/commands/cli.h"

#include <algorithm>
#include <exception>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "motion/error.h"
#include "motion/text/excerpt.h"
#include "motion/text/nearest_word.h"
#include "pipeline/base/documents/failure_text.h"
#include "pipeline/commands/command_line_fault.h"
#include "pipeline/tasks/code_identity.h"
#include "pipeline/tasks/task_graph.h"

namespace mien::pipeline {

namespace {

constexpr char description[] =
    "mien makes human motion stimuli: from adjectives to walks, videos and comparison sheets.";

constexpr char examples[] = R"(
Examples:
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

std::vector<std::string> names_of_subcommands(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* subcommand : app.get_subcommands(nullptr)) {
    names.push_back(subcommand->get_name());
  }
  return names;
}

/// Whether a word after a command may be something else than another command.
bool takes_words(const CLI::App& app) {
  const std::vector<const CLI::Option*> options = app.get_options();
  return std::any_of(options.begin(), options.end(),
                     [](const CLI::Option* option) { return option->get_positional(); });
}

/// The first word where a command should stand that is none, in a sentence; empty when all are.
std::string unknown_command(const CLI::App& app, const std::vector<std::string>& words) {
  const CLI::App* at = &app;
  for (const std::string& word : words) {
    const std::vector<std::string> known = names_of_subcommands(*at);
    if (known.empty() || word.starts_with('-')) return "";
    if (std::find(known.begin(), known.end(), word) == known.end()) {
      if (takes_words(*at)) return "";
      return "unknown command " + motion::in_quotes(word) + "; " +
             motion::did_you_mean(word, known);
    }
    at = at->get_subcommand(word);
  }
  return "";
}

/// `mien help render` means `mien render --help`.
std::vector<std::string> words_of(int argc, const char* const* argv) {
  std::vector<std::string> words(argv + 1, argv + argc);
  if (!words.empty() && words.front() == "help") {
    words.erase(words.begin());
    words.emplace_back("--help");
  }
  return words;
}

int parse(CLI::App& app, std::vector<std::string> words, const Console& console) {
  if (words.empty()) {
    console.err << app.help();
    return exit_bad_input;
  }
  if (const std::string fault = unknown_command(app, words); !fault.empty()) {
    console.err << fault << '\n';
    return exit_bad_input;
  }
  std::reverse(words.begin(), words.end());  // as CLI11 takes them
  try {
    app.parse(std::move(words));
    return exit_done;
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error, console.out, console.err);
    console.err << command_line_fault(app, error) << '\n';
    return exit_bad_input;
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
    console.err << "mien: " << failure_text(error) << '\n';
    return exit_failed;
  }
}

}  // namespace

int run_command_line(int argc, const char* const* argv, const Console& console) {
  CLI::App app(description, "mien");
  app.footer(examples + ("\n" + told_exit_codes()) +
             "Progress and faults go to standard error, results to standard output.");
  app.set_version_flag("--version", "mien " + std::string(program_version()));
  app.require_subcommand(1);
  Command chosen;
  add_run_command(app, chosen);
  add_check_command(app, chosen);
  add_plan_command(app, chosen);
  add_verify_command(app, chosen);
  add_regress_command(app, chosen);
  add_clean_command(app, chosen);
  add_pack_command(app, chosen);
  add_render_command(app, chosen);
  add_motion_command(app, chosen);
  add_manifests_command(app, chosen);
  add_sets_command(app, chosen);
  add_studio_command(app, chosen);
  add_study_command(app, chosen);
  add_farm_command(app, chosen);
  add_version_command(app, chosen);
  add_completion_command(app, chosen);
  add_man_command(app, chosen);
  if (const int code = parse(app, words_of(argc, argv), console); code != exit_done || !chosen)
    return code;
  return perform(chosen, console);
}

}  // namespace mien::pipeline
